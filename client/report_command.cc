// `tilemend report`: what report.json says, for people.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "client/water_table.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMaxLeftRows = 50;
constexpr size_t kMaxTensionRows = 10;

std::string Text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string Rounded(const Json& value) {
  return value.is_number() ? absl::StrFormat("%.4g", value.get<double>()) : Text(value);
}

// Numbers and strings as rows; groups of them with their path as a name, but no lists.
void AddRows(const Json& value, const std::string& name, std::vector<std::vector<std::string>>& rows) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      AddRows(member, name.empty() ? key : absl::StrCat(name, " ", key), rows);
  } else if (!value.is_array()) {
    rows.push_back({name, Text(value)});
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
  std::vector<std::vector<std::string>> rows;
  AddRows(report, "", rows);
  std::string text = Table({"report", ""}, rows);
  text += WaterText(report, "filled flat as water");
  text += TensionText(report);
  const auto left = report.find("left");
  if (left == report.end() || !left->is_array() || left->empty()) return text;
  std::vector<std::vector<std::string>> left_rows;
  for (const Json& item : *left) {
    if (!item.is_object() || left_rows.size() == kMaxLeftRows) continue;
    left_rows.push_back({Text(item.value("cell", Json())), Text(item.value("reason", Json()))});
  }
  absl::StrAppend(&text, "\n", left->size(), " left\n", Table({"cell", "reason"}, left_rows));
  return text;
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
        path.string(), ": not there yet: the output is not complete; run the same job again to complete it")));
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
