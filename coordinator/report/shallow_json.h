// Reading JSON files that people may have changed.
#ifndef TILEMEND_COORDINATOR_REPORT_SHALLOW_JSON_H_
#define TILEMEND_COORDINATOR_REPORT_SHALLOW_JSON_H_

#include <functional>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>

namespace tilemend {

inline constexpr int kMostDepth = 64;

struct ShallowOptions {
  // Whether a list or an object that was read stays; one that does not takes no memory any more. `depth` is 0 for the
  // whole text. Null: all stay.
  std::function<bool(int depth, const nlohmann::ordered_json& value)> keep = nullptr;
  std::stop_token stop = {};  // ends the reading
};

// What is nested deeper than kMostDepth is left out: to write 60,000 levels again takes more stack than there is.
// Discarded (is_discarded) if the text is no JSON, or after a stop. Linear but in the members of one object, where each
// is compared with those before. (The library's parser with a callback walks through the list around each object.)
nlohmann::ordered_json ParseShallow(const std::string& text, const ShallowOptions& options = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SHALLOW_JSON_H_
