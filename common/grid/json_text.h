// JSON from outside, with the place in every error.
#ifndef TILEMEND_COMMON_GRID_JSON_TEXT_H_
#define TILEMEND_COMMON_GRID_JSON_TEXT_H_

#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/statusor.h"

namespace tilemend {

// kInvalidArgument with `name`, byte, line and column if `text` is no JSON. `keep` may leave values out, which then
// take no memory (nlohmann::json::parse). A value in memory takes up to 65 bytes for a byte of text.
absl::StatusOr<nlohmann::json> ParseJson(const std::string& text, const std::string& name,
                                         const nlohmann::json::parser_callback_t& keep = nullptr);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_JSON_TEXT_H_
