// `tilemend check IN OUT`: whether an output can be delivered.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/acceptance.h"
#include "client/acceptance_text.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "client/output_file.h"
#include "client/progress_display.h"
#include "client/report_page.h"
#include "client/saved_acceptance.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "common/util/text.h"

namespace tilemend {

namespace {

// A list of an earlier check is replaced, and no other file.
absl::Status CheckCsv(const std::string& path) {
  if (path.empty()) return absl::OkStatus();
  const auto text = ReadFileUpTo(path, int64_t{1} << 30);
  absl::Status status = CheckOutputFile(path, text.ok() && text->starts_with(AcceptanceCsvHead()), "--csv");
  if (!absl::IsAlreadyExists(status)) return status;
  return absl::AlreadyExistsError(
      absl::StrCat(Printable(path), ": exists already, and is no list of `tilemend check`; choose another --csv"));
}

absl::StatusOr<Acceptance> CheckAndShow(const std::string& in, const std::string& out) {
  StepDisplay display;
  return CheckAcceptance(in, out, display.Watcher());
}

}  // namespace

int AcceptanceCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const std::string csv = args.Text("csv");
  if (const absl::Status status = CheckCsv(csv); !status.ok()) return PrintError(status);
  const auto acceptance = CheckAndShow(args.arguments()[0], args.arguments()[1]);
  if (!acceptance.ok()) return PrintError(acceptance.status());
  PrintWarnings(acceptance->warnings);
  if (!csv.empty()) {
    const absl::Status written = WriteFileAtomically(csv, AcceptanceCsv(*acceptance));
    if (!written.ok()) return PrintError(written);
  }
  if (args.Switch("page")) {
    const std::string& out = args.arguments()[1];
    absl::Status written = SaveAcceptance(out, *acceptance, absl::Now());
    if (written.ok()) written = WriteReportPage(out);
    if (!written.ok()) return PrintError(written);
  }
  const std::string text =
      *format == OutputFormat::kJson
          ? AcceptanceJson(*acceptance).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"
          : AcceptanceText(*acceptance);
  std::fputs(text.c_str(), stdout);
  return acceptance->IsAccepted() ? kExitDone : kExitSomeLeft;
}

}  // namespace tilemend
