// JSON from outside, with the place in every error.
#ifndef TILEMEND_COMMON_GRID_JSON_TEXT_H_
#define TILEMEND_COMMON_GRID_JSON_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// kInvalidArgument with `name`, byte, line and column if `text` is no JSON.
absl::StatusOr<nlohmann::json> ParseJson(const std::string& text, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_JSON_TEXT_H_
