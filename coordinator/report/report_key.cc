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

std::set<int32_t> DecidedHolesIn(const std::string& report) {
  using Event = Json::parse_event_t;
  std::set<int32_t> decided;
  std::string member, field;  // of the report, and of a row
  int32_t id = -1;
  const auto count = [&](int depth, Event event, const Json& value) {
    const bool in_row = depth == 3 && member == "per_hole";
    if (event == Event::value && in_row && field == "id" && value.is_number_integer()) id = value.get<int32_t>();
    if (event != Event::key) return depth == 0 || event == Event::object_start || event == Event::array_start;
    if (depth == 1) member = value.get<std::string>();
    if (in_row) field = value.get<std::string>();
    if (in_row && field == "decision") decided.insert(id);  // which follows the number
    return true;
  };
  return Json::parse(report, count, false).is_object() ? decided : std::set<int32_t>();
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
