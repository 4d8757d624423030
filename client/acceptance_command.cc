// `tilemend check IN OUT`: whether an output can be delivered.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "client/acceptance.h"
#include "client/acceptance_text.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"

namespace tilemend {

int AcceptanceCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const auto acceptance = CheckAcceptance(args.arguments()[0], args.arguments()[1]);
  if (!acceptance.ok()) return PrintError(acceptance.status());
  PrintWarnings(acceptance->warnings);
  if (const std::string path = args.Text("csv"); !path.empty()) {
    const absl::Status written = WriteFileAtomically(path, AcceptanceCsv(*acceptance));
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
