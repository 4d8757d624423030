// `tilemend aggregate`: a scene as one mesh, for comparison.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/time/clock.h"
#include "client/aggregate.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/left_table.h"
#include "client/output.h"
#include "client/output_file.h"
#include "client/progress_display.h"
#include "common/util/files.h"
#include "common/util/place.h"
#include "common/util/text.h"
#include "common/util/utc.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/tile_checks.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

absl::StatusOr<AggregateOptions> OptionsFromFlags(const Args& args) {
  AggregateOptions options;
  if (args.IsGiven("memory")) {
    const auto megabytes = args.Number("memory", 64, 1e9);
    if (!megabytes.ok()) return megabytes.status();
    options.memory_bytes = static_cast<int64_t>(*megabytes * 1e6);
  }
  const auto longest = WholeNumberIfGiven(args, "longest-loop", 3, 20000);
  if (!longest.ok()) return longest.status();
  options.longest_loop = longest->value_or(options.longest_loop);
  return options;
}

absl::Status CheckPath(const std::string& out, bool overwrite) {
  if (fs::path(out).extension() != ".ply") {
    return absl::InvalidArgumentError(
        absl::StrCat(out, ": the joined mesh is written as PLY; choose an --out that ends in .ply"));
  }
  return CheckOutputFile(out, overwrite);
}

// Whether the output would not lie among the scene's files, by another name either.
absl::Status CheckApart(const std::string& out, const Scene& scene) {
  std::error_code error;
  const fs::path root = fs::weakly_canonical(scene.root, error), file = fs::weakly_canonical(out, error);
  if (!error && std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first != root.end()) {
    return absl::OkStatus();
  }
  return absl::InvalidArgumentError(
      absl::StrCat(out, ": the output would be written into the scene, ", root.string(), "; choose another --out"));
}

// A new folder beside the output, for the joined mesh.
absl::StatusOr<std::string> MakeFolderBeside(const std::string& out) {
  std::string folder = (fs::path(out).parent_path() / ".tilemend-aggregate-XXXXXX").string();
  if (mkdtemp(folder.data()) != nullptr) return folder;
  return WithOtherOut(WriteErrnoStatus(errno, "cannot make a folder beside it", out));
}

absl::StatusOr<FilledMesh> FillAndShow(const Scene& scene, AggregateOptions options) {
  StepDisplay display;
  options.watcher = display.Watcher();
  return AggregateAndFill(scene, options);
}

void Print(const SceneReportInput& report, const std::string& out, OutputFormat format) {
  if (format == OutputFormat::kJson) {
    std::fputs(SceneReport(report).c_str(), stdout);
    return;
  }
  const size_t holes = report.plan->holes.size(), left = report.outcome.failures.size();
  std::fputs(
      absl::StrFormat("%d of %d closed holes of the joined mesh filled; %s left open\nwritten: %s\n", holes - left,
                      holes, Counted(static_cast<size_t>(report.plan->outer_rims), "outline"), Printable(out))
          .c_str(),
      stdout);
  std::fputs(LeftLines(report).c_str(), stderr);
}

}  // namespace

int AggregateCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  auto options = OptionsFromFlags(args);
  if (!options.ok()) return PrintUsageError(options.status());
  const std::string out = args.Text("out");
  if (const absl::Status status = CheckPath(out, args.Switch("overwrite")); !status.ok()) return PrintError(status);
  const auto scene = LoadScene(args.arguments().front(), ReadTileHull, ReadTilesets);
  if (!scene.ok()) return PrintError(scene.status());
  if (const absl::Status status = CheckApart(out, *scene); !status.ok()) return PrintError(status);
  SignalWatcher signals;  // before other threads
  auto lock = OutputLock::Take(out);
  if (!lock.ok()) return PrintError(lock.status());
  const auto folder = MakeFolderBeside(out);
  if (!folder.ok()) return PrintError(folder.status());
  const auto remove_joined = [&] {
    std::error_code error;
    fs::remove_all(*folder, error);
  };
  const absl::Cleanup remove_at_end = remove_joined;
  CancelOnSignal(signals, [&] {
    remove_joined();
    lock->Release();
  });
  options->joined = absl::StrCat(*folder, "/joined.ply");
  auto filled = FillAndShow(*scene, *options);
  signals.Stop();
  if (!filled.ok()) return PrintError(filled.status());
  // Somebody else may have written there since.
  if (const absl::Status status = CheckPath(out, args.Switch("overwrite")); !status.ok()) return PrintError(status);
  if (const absl::Status status = WriteFileAtomically(out, filled->bytes); !status.ok()) return PrintError(status);
  filled->report.scene = args.arguments().front();
  filled->report.options = {{"filler", FillerName(Filler::kMinimumArea)},
                            {"longest-loop", 1.0 * options->longest_loop}};
  filled->report.date = UtcText(absl::Now());
  Print(filled->report, out, *format);
  return SomeHolesLeft(filled->report) ? kExitSomeLeft : kExitDone;
}

}  // namespace tilemend
