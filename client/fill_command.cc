// `tilemend fill`: the holes of one mesh, without a grid.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "absl/time/clock.h"
#include "client/commands.h"
#include "client/filler_flags.h"
#include "client/job_flags.h"
#include "client/left_table.h"
#include "client/mesh_filler.h"
#include "client/output.h"
#include "client/output_file.h"
#include "client/progress_display.h"
#include "common/codec/mesh_file.h"
#include "common/records/surface.h"
#include "common/util/colour.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "common/util/text.h"
#include "common/util/utc.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/water_choice.h"
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
absl::StatusOr<std::vector<std::string>> WriteFilesBeside(const std::string& in, const std::string& out, bool overwrite,
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
      if (overwrite || !std::filesystem::exists(absl::StrCat(to, "/", file), error)) {
        carried.push_back(file);
      } else {
        warnings.push_back(absl::StrCat(to, "/", file, ": exists already and is left as it is"));
      }
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(const auto failed, CarryFiles(FolderOf(in), to, carried, false));
  warnings.insert(warnings.end(), failed.begin(), failed.end());
  return warnings;
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
  if (from == MeshFormat::kOsgb) {
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

absl::Status ReadHoleOptions(const Args& args, MeshHoleOptions& holes) {
  holes.fill_outlines = args.Switch("fill-outlines");
  if (args.IsGiven("largest-hole")) {
    TILEMEND_ASSIGN_OR_RETURN(const double edges, args.Number("largest-hole", 3, 1e9));
    holes.largest_hole = static_cast<int64_t>(edges);
  }
  if (args.IsGiven("dislocation-width")) {
    TILEMEND_ASSIGN_OR_RETURN(holes.dislocation_width, args.Number("dislocation-width", 1e-12, 1e9));
  }
  return absl::OkStatus();
}

absl::Status ReadTension(const Args& args, FillOptions& options) {
  TILEMEND_ASSIGN_OR_RETURN(options.tension, TensionFromFlags(args));
  if (options.tension && options.surface != Surface::kThinPlate)
    return absl::InvalidArgumentError("--tension: the surface wang has none; leave it out, or choose thin-plate");
  if (options.tension && options.filler != Filler::kAuto)
    return absl::InvalidArgumentError(
        absl::StrCat("--tension: the filler ", FillerName(options.filler), " has none; leave it out, or choose auto"));
  return absl::OkStatus();
}

// Beside what holds for jobs as well: what published ways do not have is for thin-plate and the filler auto.
absl::Status CheckHaveEffect(const Args& args, const FillOptions& options) {
  TILEMEND_RETURN_IF_ERROR(CheckHaveEffect(args));
  const bool is_ours = options.surface == Surface::kThinPlate && options.filler == Filler::kAuto;
  if (args.Switch("allow-creases") && !is_ours) {
    return absl::InvalidArgumentError(
        "--allow-creases: what is published is filled as published, creases and all; leave one of the two out");
  }
  for (const char* flag : {"gradation", "size-limit"}) {
    if (args.IsGiven(flag) && HasFront(options.filler) && args.Text("water") == "off") {
      return absl::InvalidArgumentError(absl::StrCat("--", flag, ": the triangles of ", FillerName(options.filler),
                                                     " are as large as the boundary's; leave it out"));
    }
  }
  return absl::OkStatus();
}

// Flags that are out of their range are kInvalidArgument.
absl::StatusOr<MeshFillOptions> FillOptionsFromFlags(const Args& args) {
  MeshFillOptions all;
  FillOptions& options = all.fill;
  const std::optional<Surface> surface = SurfaceNamed(args.Text("surface"));
  if (!surface) {
    return absl::InvalidArgumentError(
        absl::StrCat("--surface '", args.Text("surface"), "': expected thin-plate or wang"));
  }
  options.surface = *surface;
  TILEMEND_ASSIGN_OR_RETURN(options.filler, FillerFromFlags(args));
  if (options.surface == Surface::kWang && options.filler != Filler::kAuto)
    return absl::InvalidArgumentError(
        "--filler: the surface wang fills closed holes in its own way; leave one of the two out");
  TILEMEND_RETURN_IF_ERROR(ReadFillerFlags(args, options));
  TILEMEND_RETURN_IF_ERROR(CheckHaveEffect(args, options));
  TILEMEND_RETURN_IF_ERROR(ReadTension(args, options));
  TILEMEND_ASSIGN_OR_RETURN(const auto longest_loop, WholeNumberIfGiven(args, "longest-loop", 3, 2000));
  TILEMEND_ASSIGN_OR_RETURN(const auto fairing_steps, WholeNumberIfGiven(args, "fairing-steps", 0, 1000));
  if ((longest_loop || fairing_steps) && options.surface != Surface::kWang && options.filler != Filler::kMinimumArea) {
    return absl::InvalidArgumentError(
        "--longest-loop, --fairing-steps: only the surface wang and the filler minimum-area have these options; leave "
        "them out, or choose one of these");
  }
  if (longest_loop) options.wang.longest_loop = *longest_loop;
  if (fairing_steps) options.wang.fairing_steps = *fairing_steps;
  TILEMEND_ASSIGN_OR_RETURN(options.refine.gradation, args.Number("gradation", 1, 10));
  TILEMEND_ASSIGN_OR_RETURN(options.refine.size_limit, args.Number("size-limit", 1, 1e6));
  options.refine.uniform = args.Switch("uniform");
  if (const std::string colour = args.Text("water-colour"); !colour.empty()) {
    all.water_colour = ParseColour(colour);
    if (!all.water_colour)
      return absl::InvalidArgumentError(absl::StrCat("--water-colour '", colour, "': expected ", kColourForm));
  }
  options.allow_creases = args.Switch("allow-creases");
  TILEMEND_ASSIGN_OR_RETURN(all.weld, NumberIfGiven(args, "weld", 1e-12, 1e9));
  TILEMEND_RETURN_IF_ERROR(ReadHoleOptions(args, all.holes));
  all.library = LibraryFor(args.Text("out"));
  return all;
}

// The options that the result depends on, under the names of their flags.
std::vector<ReportedOption> ReportedOptionsOf(const Args& args, const MeshFillOptions& all) {
  const FillOptions& options = all.fill;
  ReportedOption tension{"tension", std::string("auto")}, largest{"largest-hole", std::string("any")};
  if (options.tension) tension.value = *options.tension;
  ReportedOption dislocation{"dislocation-width", std::string("auto")};
  if (all.holes.dislocation_width) dislocation.value = *all.holes.dislocation_width;
  if (all.holes.largest_hole) largest.value = static_cast<double>(*all.holes.largest_hole);
  ReportedOption weld{"weld", std::string("off")};
  if (all.weld) weld.value = *all.weld;
  std::vector<ReportedOption> reported = ReportedFillerOptions(options);
  const std::vector<ReportedOption> others = {tension,
                                              {"gradation", options.refine.gradation},
                                              {"size-limit", options.refine.size_limit},
                                              {"uniform", options.refine.uniform},
                                              {"allow-creases", options.allow_creases},
                                              dislocation,
                                              weld,
                                              {"fill-outlines", all.holes.fill_outlines},
                                              largest,
                                              {"water", args.Text("water")},
                                              {"water-profile", args.Text("water-profile")},
                                              {"water-colour", args.Text("water-colour")},
                                              {"clear", args.Text("clear")}};
  reported.insert(reported.end(), others.begin(), others.end());
  return reported;
}

absl::StatusOr<FilledMesh> FillAndShow(const std::string& in, MeshFillOptions options) {
  StepDisplay display;
  options.show = [&display](std::string_view step, size_t done, size_t all) { display.Show(step, done, all); };
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
  auto options = FillOptionsFromFlags(args);
  if (!options.ok()) return PrintUsageError(options.status());
  const auto profile = WaterProfileFromFlags(args);
  if (!profile.ok()) return PrintUsageError(profile.status());
  const std::string& in = args.arguments().front();
  const std::string out = args.Text("out");
  const bool overwrite = args.Switch("overwrite");
  if (const absl::Status status = CheckPaths(in, out, overwrite); !status.ok()) return PrintError(status);
  SignalWatcher signals;  // before other threads
  auto lock = OutputLock::Take(out);
  if (!lock.ok()) return PrintError(lock.status());
  CancelOnSignal(signals, [&lock] { lock->Release(); });
  auto water = ReadWaterChoice(args.Text("water"), SceneFrame());
  if (!water.ok()) return PrintError(water.status());
  if (const absl::Status status = AddClearFile(args.Text("clear"), SceneFrame(), *water); !status.ok()) {
    return PrintError(status);
  }
  water->options.profile = *profile;
  options->water = water->options;
  auto filled = FillAndShow(in, *options);
  signals.Stop();
  if (!filled.ok()) return PrintError(filled.status());
  Stopwatch watch;
  // Somebody else may have written there since.
  if (const absl::Status status = CheckPaths(in, out, overwrite); !status.ok()) return PrintError(status);
  auto warnings = WriteFilesBeside(in, out, overwrite, *filled);
  if (!warnings.ok()) return PrintError(warnings.status());
  filled->report.warnings.insert(filled->report.warnings.end(), warnings->begin(), warnings->end());
  if (const absl::Status status = WriteFileAtomically(out, filled->bytes); !status.ok()) return PrintError(status);
  filled->report.seconds.emplace_back("write", watch.Lap());
  filled->report.options = ReportedOptionsOf(args, *options);
  return PrintEnd(filled->report, out, *format);
}

}  // namespace tilemend
