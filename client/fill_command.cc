// `tilemend fill`: the holes of one mesh, without a grid.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "absl/time/clock.h"
#include "client/commands.h"
#include "client/job_flags.h"
#include "client/left_table.h"
#include "client/mesh/mesh_filler.h"
#include "client/mesh/mesh_options.h"
#include "client/output.h"
#include "client/output_file.h"
#include "client/progress_display.h"
#include "common/codec/mesh_file.h"
#include "common/options/job_options.h"
#include "common/records/surface.h"
#include "common/store/fingerprint.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "common/util/text.h"
#include "common/util/utc.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/scene_report.h"
#include "worker/materials/write_materials.h"

namespace tilemend {
namespace {

// The name of the material file of an output, beside it.
std::string LibraryFor(const std::string& out) {
  return absl::StrCat(std::filesystem::path(out).stem().string(), "_tilemend.mtl");
}

std::string FolderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

// Writes the materials of the filled faces, and carries what the mesh names to the output's folder, where it is not
// there already. Gives warnings.
absl::StatusOr<std::vector<std::string>> WriteFilesBeside(const std::string& in, const std::string& out,
                                                          const FilledMesh& filled) {
  const std::string to = FolderOf(out);
  const std::string own = filled.materials.empty() ? "" : LibraryFor(out);
  if (!own.empty()) {
    // The mesh may come from here, and have one of this name already.
    const auto& named = filled.files.libraries;
    const bool is_named = std::find(named.begin(), named.end(), own) != named.end();
    TILEMEND_RETURN_IF_ERROR(WriteMaterials(is_named ? absl::StrCat(FolderOf(in), "/", own) : "",
                                            absl::StrCat(to, "/", own), filled.materials));
  }
  std::error_code error;
  if (std::filesystem::equivalent(FolderOf(in), to, error)) return std::vector<std::string>();
  std::vector<std::string> carried, warnings = filled.files.warnings;
  for (const auto* files : {&filled.files.libraries, &filled.files.images}) {
    for (const std::string& file : *files) {
      if (file == own) continue;
      const std::string there = absl::StrCat(to, "/", file);
      if (!std::filesystem::exists(there, error)) {
        carried.push_back(file);
      } else if (!HaveSameContent(absl::StrCat(FolderOf(in), "/", file), there)) {
        // Another mesh may need it; --overwrite is about FILE alone.
        warnings.push_back(absl::StrCat(there,
                                        ": is another file than the input's and is left as it is, so the output "
                                        "may look wrong; choose an --out in another folder"));
      }
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(const auto failed, CarryFiles(FolderOf(in), to, carried, false));
  warnings.insert(warnings.end(), failed.begin(), failed.end());
  return warnings;
}

// Writes the mesh and what goes beside it. Gives warnings. If it fails, the material file of the output goes again: the
// next try would want --overwrite for it. What was carried stays, as another output in the folder may name it by now.
absl::StatusOr<std::vector<std::string>> WriteOutput(const std::string& in, const std::string& out,
                                                     const FilledMesh& filled) {
  const std::string library = absl::StrCat(FolderOf(out), "/", LibraryFor(out));
  std::error_code error;
  const bool makes_library =
      !filled.materials.empty() && !std::filesystem::exists(std::filesystem::symlink_status(library, error));
  auto warnings = WriteFilesBeside(in, out, filled);
  const absl::Status status = warnings.ok() ? WriteFileAtomically(out, filled.bytes) : warnings.status();
  if (status.ok()) return warnings;
  if (makes_library) RemoveFile(library).IgnoreError();
  return status;
}

absl::Status CheckPaths(const std::string& in, const std::string& out, bool overwrite) {
  std::error_code error;
  if (std::filesystem::is_directory(in, error)) {
    return absl::InvalidArgumentError(absl::StrCat(in, ": is a folder; `tilemend run` fills scenes"));
  }
  if (std::filesystem::equivalent(in, out, error) && !error) {
    return absl::InvalidArgumentError(
        absl::StrCat(out, ": the output would be written over the input; choose another --out"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat from, MeshFormatOf(in));
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat to, MeshFormatOf(out));
  if (from == MeshFormat::kTileTree) {
    return absl::InvalidArgumentError(absl::StrCat(in, ": is a tile of a scene; `tilemend run` fills scenes"));
  }
  if (from != to)
    return absl::InvalidArgumentError(absl::StrCat(out, ": the output has the format of the input, ", in,
                                                   "; choose an --out that ends in ",
                                                   std::filesystem::path(in).extension().string()));
  TILEMEND_RETURN_IF_ERROR(ReadFileEnds(in, 0).status());
  TILEMEND_RETURN_IF_ERROR(CheckOutputFile(out, overwrite));
  return to == MeshFormat::kObj ? CheckOutputFile(absl::StrCat(FolderOf(out), "/", LibraryFor(out)), overwrite)
                                : absl::OkStatus();
}

// How many vertices were welded to stdout, and what was not and why to stderr.
void PrintWeld(const WeldRecord& weld) {
  std::fputs(absl::StrFormat("%s welded onto others, %s split\n", Counted(weld.welded.size(), "boundary point"),
                             Counted(weld.split.size(), "edge"))
                 .c_str(),
             stdout);
  std::map<std::string, size_t> reasons;
  for (const RefusedWeld& r : weld.refused) ++reasons[r.reason];
  for (const auto& [reason, count] : reasons) {
    std::fprintf(stderr, "not welded: %s: %s\n", Counted(count, "pair").c_str(), reason.c_str());
  }
}

// " by FILLER" or " by the surface wang", where it is not the default.
std::string ByWhom(const std::vector<ReportedOption>& options) {
  std::string text;
  for (const auto& [name, value] : options) {
    const auto* word = std::get_if<std::string>(&value);
    if (name == "surface" && *word != SurfaceName(kDefaultSurface)) text = absl::StrCat(" by the surface ", *word);
    if (name == "filler" && *word != FillerName(Filler::kAuto)) text = absl::StrCat(" by ", *word);
  }
  return text;
}

void PrintSummary(const SceneReportInput& report, const std::string& out) {
  if (report.weld) PrintWeld(*report.weld);
  const Plan& plan = *report.plan;
  int64_t vertices = 0, triangles = 0;
  for (const auto& [hole, size] : report.outcome.sizes) {
    vertices += size.new_vertices;
    triangles += size.triangles;
  }
  std::fputs(
      absl::StrFormat("%d of %s filled%s with %s and %s; %s left open\nwritten: %s\n",
                      plan.holes.size() - report.outcome.failures.size(), Counted(plan.holes.size(), "hole"),
                      ByWhom(report.options), vertices == 1 ? "1 new vertex" : absl::StrCat(vertices, " new vertices"),
                      Counted(static_cast<size_t>(triangles), "triangle"),
                      Counted(static_cast<size_t>(plan.outer_rims), "outline"), Printable(out))
          .c_str(),
      stdout);
  size_t taken_out = 0;
  for (const ClearedArea& area : report.outcome.cleared) {
    for (const auto& [cell, count] : area.triangles_of) taken_out += static_cast<size_t>(count);
  }
  if (taken_out > 0) std::fputs(absl::StrCat(Counted(taken_out, "original triangle"), " taken out\n").c_str(), stdout);
  PrintWarnings(WarningsOf(report));
  std::fputs(LeftLines(report).c_str(), stderr);
}

// kInvalidArgument names a flag that is out of its range or has no effect.
absl::StatusOr<v1::JobSpec> FillSpecFromFlags(const Args& args) {
  TILEMEND_ASSIGN_OR_RETURN(const v1::JobSpec spec, SpecFromFlags(args, kOfFill));
  TILEMEND_RETURN_IF_ERROR(NamedAsFlag(CheckMeshOptions(spec, GivenBy(args))));
  return spec;
}

absl::StatusOr<FilledMesh> FillAndShow(const std::string& in, MeshFillOptions options) {
  StepDisplay display;
  options.show = [&display](std::string_view step, size_t done, size_t all) { display.Show(step, done, all, "hole"); };
  return FillMesh(in, options);
}

int PrintEnd(SceneReportInput& report, const std::string& out, OutputFormat format) {
  report.date = UtcText(absl::Now());
  if (format == OutputFormat::kJson) {
    std::fputs(SceneReport(report).c_str(), stdout);
  } else {
    PrintSummary(report, out);
  }
  return SomeHolesLeft(report) ? kExitSomeLeft : kExitDone;
}

}  // namespace

int FillCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const auto spec = FillSpecFromFlags(args);
  if (!spec.ok()) return PrintUsageError(spec.status());
  const std::string& in = args.arguments().front();
  const std::string out = spec->out();
  const bool overwrite = spec->overwrite();
  if (const absl::Status status = CheckPaths(in, out, overwrite); !status.ok()) return PrintError(status);
  SignalWatcher signals;  // before other threads
  auto lock = OutputLock::Take(out);
  if (!lock.ok()) return PrintError(lock.status());
  CancelOnSignal(signals, [&lock] { lock->Release(); });
  auto options = MeshOptionsOf(*spec);
  if (!options.ok()) return PrintError(options.status());
  options->library = LibraryFor(out);
  auto filled = FillAndShow(in, *std::move(options));
  signals.Stop();
  if (!filled.ok()) return PrintError(filled.status());
  Stopwatch watch;
  // Somebody else may have written there since.
  if (const absl::Status status = CheckPaths(in, out, overwrite); !status.ok()) return PrintError(status);
  const auto warnings = WriteOutput(in, out, *filled);
  if (!warnings.ok()) return PrintError(warnings.status());
  filled->report.warnings.insert(filled->report.warnings.end(), warnings->begin(), warnings->end());
  filled->report.seconds.emplace_back("write", watch.Lap());
  filled->report.options = ReportedOptions(*spec, kOfFill);
  return PrintEnd(filled->report, out, *format);
}

}  // namespace tilemend
