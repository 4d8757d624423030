#include "coordinator/report/report_key.h"

#include <nlohmann/json.hpp>

namespace tilemend {

std::string KeyInReport(const std::string& report) {
  using Json = nlohmann::json;
  const auto keep = [](int depth, Json::parse_event_t event, const Json&) {
    return depth != 1 || (event != Json::parse_event_t::object_start && event != Json::parse_event_t::array_start);
  };
  const Json json = Json::parse(report, keep, false);
  if (!json.is_object()) return "";
  const auto key = json.find("key");
  return key != json.end() && key->is_string() ? key->get<std::string>() : "";
}

}  // namespace tilemend
