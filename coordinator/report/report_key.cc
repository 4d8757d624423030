#include "coordinator/report/report_key.h"

#include <nlohmann/json.hpp>

#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// A report without its lists. Null if it is none.
Json ReadHead(const std::string& report) {
  const auto keep = [](int depth, Json::parse_event_t event, const Json&) {
    return depth != 1 || event != Json::parse_event_t::array_start;
  };
  Json json = Json::parse(report, keep, false);
  return json.is_object() ? json : Json();
}

ReportedOption OptionOf(const std::string& name, const Json& value) {
  if (value.is_boolean()) return {name, value.get<bool>()};
  if (value.is_number()) return {name, value.get<double>()};
  return {name, Text(value)};
}

}  // namespace

std::string KeyInReport(const std::string& report) {
  const Json head = ReadHead(report);
  const Json& key = Member(head, "key");
  return key.is_string() ? key.get<std::string>() : "";
}

std::optional<ReportedJob> JobInReport(const std::string& report) {
  const Json head = ReadHead(report);
  const Json& options = Member(head, "options");
  if (!options.is_object()) return std::nullopt;
  ReportedJob job{Text(Member(head, "scene")), {}, {}};
  for (const auto& [name, value] : options.items()) job.options.push_back(OptionOf(name, value));
  for (const auto& [option, digest] : Member(head, "files").items()) job.files[option] = Text(digest);
  return job;
}

}  // namespace tilemend
