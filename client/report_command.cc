// `tilemend report`: what report.json says, for people.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/left_table.h"
#include "client/output.h"
#include "client/water_table.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMaxTensionRows = 10;

std::string Text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Rounded(const Json& value) {
  return value.is_number() ? absl::StrFormat("%.4g", value.get<double>()) : Text(value);
}

using Rows = std::vector<std::vector<std::string>>;

// Numbers and strings as rows, groups of them with their path as a name, but no lists; of `counts` no zeros.
void AddRows(const Json& value, const std::string& name, bool counts, Rows& rows) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) AddRows(member, absl::StrCat(name, " ", key), counts, rows);
  } else if (!value.is_array() && !(counts && value.is_number() && value == 0)) {
    rows.push_back({name, Text(value)});
  }
}

int64_t Total(const Json& counts) {
  if (counts.is_number_integer()) return counts.get<int64_t>();
  int64_t total = 0;
  if (counts.is_object()) {
    for (const Json& member : counts) total += Total(member);
  }
  return total;
}

// The members of the report in units for people.
void AddMember(const std::string& key, const Json& value, Rows& rows) {
  const bool sums = key == "holes" || key == "filled";
  if (sums) rows.push_back({key, absl::StrCat(Total(value))});
  if (key == "seconds" && value.is_object()) {
    for (const auto& [stage, seconds] : value.items())
      rows.push_back({absl::StrCat("seconds ", stage),
                      seconds.is_number() ? absl::StrFormat("%.3f", seconds.get<double>()) : Text(seconds)});
  } else if (key == "peak_rss_bytes" && value.is_number()) {
    rows.push_back({"peak memory, MB", absl::StrFormat("%.0f", value.get<double>() / 1e6)});
  } else {
    const bool counts = sums || key == "single" || key == "borders" || key == "continuous" || key == "outer_rims";
    AddRows(value, key, counts, rows);
  }
}

// The tensions that were chosen from the rim; the error of a hold-out is there for information.
std::string TensionText(const Json& report) {
  const auto choices = report.find("tension");
  if (choices == report.end() || !choices->is_array() || choices->empty()) return "";
  std::vector<std::vector<std::string>> rows;
  for (const Json& choice : *choices) {
    if (!choice.is_object() || rows.size() == kMaxTensionRows) continue;
    const char* kind = choice.contains("cluster") ? "cluster" : "hole";
    rows.push_back({absl::StrCat(kind, " ", Text(choice.value(kind, Json()))), Rounded(choice.value("tension", Json())),
                    Text(choice.value("hold_out_error_m", Json()))});
  }
  return absl::StrCat("\n", Counted(choices->size(), "tension"), " chosen from the rim\n",
                      Table({"", "tension, 1/m2", "hold-out error, m"}, rows));
}

std::string ReportText(const Json& report) {
  Rows rows;
  for (const auto& [key, value] : report.items()) AddMember(key, value, rows);
  return absl::StrCat(Table({"report", ""}, rows), WaterText(report, "filled flat as water"), TensionText(report),
                      LeftText(report, "left"));
}

}  // namespace

int ReportCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  std::filesystem::path path = args.arguments().front();
  if (path.extension() != ".json") path /= "report.json";
  const auto content = ReadFile(path.string());
  if (absl::IsNotFound(content.status()) && std::filesystem::exists(path.parent_path() / ".tilemend-job")) {
    return PrintError(absl::NotFoundError(absl::StrCat(
        path.string(), ": not there yet; the output is not complete. Run the same job again to complete it")));
  }
  if (!content.ok()) return PrintError(content.status());
  const Json report = Json::parse(*content, nullptr, false);
  if (!report.is_object() || !report.contains("cells")) {
    return PrintError(absl::InvalidArgumentError(
        absl::StrCat(path.string(), ": not a report (expected a JSON object with the field cells)")));
  }
  std::fputs((*format == OutputFormat::kJson ? *content : ReportText(report)).c_str(), stdout);
  return kExitDone;
}

}  // namespace tilemend
