#include "client/job_end.h"

#include <string_view>

#include "absl/strings/str_cat.h"
#include "client/output.h"
#include "client/report_text.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/utc.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// `text` as one word of a shell's command line: as it is, or in single quotes.
std::string ShellWord(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

// Whether the report was made while the job ran: a later job in the same folder replaces it. Both times are of the
// coordinator's clock. One without a date is taken as it is.
bool IsFromThen(const Json& report, const v1::Job& job) {
  const std::string date = Text(Member(report, "date"));
  if (date.empty() || !job.has_create_time() || !job.has_end_time()) return true;
  return UtcText(TimeOf(job.create_time())) <= date && date <= UtcText(TimeOf(job.end_time()));
}

}  // namespace

std::string CheckLine(const std::string& scene, const std::string& out) {
  return absl::StrCat("check: tilemend check ", Printable(ShellWord(scene)), " ", Printable(ShellWord(out)), "\n");
}

bool CanBeChecked(const v1::Job& job) {
  const v1::JobSpec& spec = job.spec();
  return (job.state() == v1::DONE || job.state() == v1::PARTIAL) && !spec.dry_run();
}

absl::StatusOr<Json> ReportOf(const v1::Job& job) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string content, ReadFile(job.report()));
  Json report = ParseShallow(content);
  if (report.is_object()) return report;
  return absl::InvalidArgumentError(absl::StrCat(job.report(), ": not a report"));
}

std::string ClusterEndText(const v1::Job& job, size_t columns) {
  if (job.report().empty()) return "";
  const std::string command = absl::StrCat("tilemend report ", Printable(ShellWord(job.spec().out())));
  const auto report = ReportOf(job);
  if (!report.ok()) {
    return absl::StrCat("\nwarnings and what is left: in the report, which this machine cannot read (",
                        Printable(std::string(report.status().message())), ")\nwhere it can be read: ", command, "\n");
  }
  if (!IsFromThen(*report, job)) {
    return absl::StrCat(
        "\nwarnings: the report there is of another job in the same folder by now\nthat report: ", command, "\n");
  }
  return absl::StrCat(SummaryText(*report, columns), "\npage: ", command,
                      " --html (writes it; it opens in a browser)\n",
                      CanBeChecked(job) ? CheckLine(job.spec().scene(), job.spec().out()) : "");
}

}  // namespace tilemend
