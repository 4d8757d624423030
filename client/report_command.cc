// `tilemend report`: what report.json says, for people.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "client/report_page.h"
#include "client/report_text.h"
#include "client/unfinished.h"
#include "common/util/files.h"
#include "common/util/standard_streams.h"
#include "common/util/text.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

int ReportCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const std::string& folder = args.arguments().front();
  std::filesystem::path path = folder;
  const bool is_folder = path.extension() != ".json";
  if (is_folder) path /= "report.json";
  if (args.Switch("html") && path.filename() != "report.json") {
    return PrintUsageError(absl::InvalidArgumentError(
        absl::StrCat("report: --html makes the page of the report.json in an output's folder, not of ", path.string(),
                     "; give the folder, or leave --html out")));
  }
  const auto content = ReadFile(path.string());
  const auto finished = path.filename() == "report.json" ? CheckFinished(path.parent_path()) : absl::OkStatus();
  if (!finished.ok()) return PrintError(finished);
  if (!content.ok()) {
    const absl::Status status = is_folder ? CheckHasReport(folder) : absl::OkStatus();
    return PrintError(status.ok() ? content.status() : status);
  }
  const Json report = ParseShallow(*content);
  if (!report.is_object() || !report.contains("cells")) {
    return PrintError(absl::InvalidArgumentError(
        absl::StrCat(path.string(), ": not a report (expected a JSON object with the field cells)")));
  }
  if (args.Switch("html")) {
    const absl::Status written = WriteReportPage(path.has_parent_path() ? path.parent_path().string() : ".");
    if (!written.ok()) return PrintError(written);
    const std::filesystem::path page = path.parent_path() / "report.html";
    std::fprintf(stderr, "tilemend: wrote %s\n", Printable(page.string()).c_str());
    if (*format != OutputFormat::kJson) return kExitDone;  // the page is in place of the text
  }
  std::fputs((*format == OutputFormat::kJson ? *content : ReportText(report, ColumnsOfTerminal(STDOUT_FILENO))).c_str(),
             stdout);
  return kExitDone;
}

}  // namespace tilemend
