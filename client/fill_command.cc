// `tilemend fill`: the holes of one mesh, without a grid.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/commands.h"
#include "client/inspection.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "common/util/files.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/water_choice.h"
#include "worker/assemble/assemble.h"
#include "worker/fill/fill_holes.h"
#include "worker/fill/shape/patch_quality.h"
#include "worker/fill/space/surface_index.h"

namespace tilemend {
namespace {

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
  if (from != to)
    return absl::InvalidArgumentError(absl::StrCat(out, ": expected a file name with the format of the input, ", in));
  if (std::filesystem::is_directory(out, error)) {
    return absl::InvalidArgumentError(absl::StrCat(out, ": the output is a folder; choose another --out"));
  }
  if (!overwrite && std::filesystem::exists(out, error)) {
    return absl::AlreadyExistsError(absl::StrCat(out, ": exists already; choose another --out, or give --overwrite"));
  }
  return absl::OkStatus();
}

struct Filled {
  SceneReportInput report;
  std::string bytes;
};

// The patches of all holes that the plan finds no fault with, as one.
FilePatch FillAll(const MeshInspection& mesh, const FillOptions& options, const SurfaceNear& near, size_t vertex_count,
                  SceneReportInput& report) {
  std::vector<int32_t> holes;
  for (size_t h = 0; h < mesh.plan.holes.size(); ++h) {
    if (mesh.plan.holes[h].failure.empty()) holes.push_back(static_cast<int32_t>(h));
  }
  if (holes.empty()) return {};
  const CellHoles work = MakeCellHoles(mesh.plan, mesh.input, SeamHeights(), holes, true);
  const std::vector<HolePatch> patches = FillHoles(work, options, near);
  for (const HolePatch& p : patches) {
    if (!p.failure.empty()) report.failures[p.hole] = p.failure;
    report.sizes[p.hole] = {p.new_points.size(), p.triangles.size()};
    if (p.hold_out) report.of_holes[p.hole] = *p.hold_out;
  }
  report.quality = TallyQuality(work, patches);
  return MergePatches(work.vertices, patches, work.cell, static_cast<int32_t>(vertex_count));
}

absl::StatusOr<Filled> FillMesh(const std::string& path, const FillOptions& options, const WaterOptions& water,
                                MeshInspection& mesh) {
  Filled filled;
  SceneReportInput& report = filled.report;
  report.plan = &mesh.plan;
  report.cells = 1;
  report.given_tension = options.tension;
  report.surface = options.surface == Surface::kThinPlate ? "thin-plate" : "wang";
  KeepHeap();
  Stopwatch watch;
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadFile(path));
  TILEMEND_ASSIGN_OR_RETURN(MeshFile file, ParseMesh(format, bytes, path));
  report.seconds.emplace_back("read", watch.Lap());
  InspectMesh(file, {options.refine.gradation, options.refine.size_limit, options.refine.uniform, water}, mesh);
  report.seconds.emplace_back("survey", watch.Lap());
  const size_t vertex_count = file.mesh.points.size();
  file = {};                            // the fill needs the room
  std::optional<SurfaceIndex> surface;  // read again for holes that are no heights over the ground
  absl::Status read;
  const auto near = [&](const Point3& lo, const Point3& hi) {
    std::vector<SpaceTriangle> found;
    if (!surface) {
      auto again = ParseMesh(format, bytes, path);
      read = again.status();
      surface.emplace(again.ok() ? std::move(again->mesh) : TriMesh());
    }
    surface->AppendNear(lo, hi, found);
    return found;
  };
  const FilePatch patch = FillAll(mesh, options, near, vertex_count, report);
  TILEMEND_RETURN_IF_ERROR(read);
  surface.reset();
  report.seconds.emplace_back("fill", watch.Lap());
  if (patch.triangles.empty()) {
    filled.bytes = std::move(bytes);
  } else {
    TILEMEND_ASSIGN_OR_RETURN(filled.bytes, AppendPatch(format, bytes, patch, path));
  }
  report.seconds.emplace_back("assemble", watch.Lap());
  return filled;
}

void PrintSummary(const Filled& filled, const std::string& out) {
  const Plan& plan = *filled.report.plan;
  int64_t vertices = 0, triangles = 0;
  for (const auto& [hole, size] : filled.report.sizes) {
    vertices += size.first;
    triangles += size.second;
  }
  std::fputs(absl::StrFormat("%d of %s filled with %s and %s; %s left open\nwritten: %s\n",
                             plan.holes.size() - filled.report.failures.size(), Counted(plan.holes.size(), "hole"),
                             vertices == 1 ? "1 new vertex" : absl::StrCat(vertices, " new vertices"),
                             Counted(static_cast<size_t>(triangles), "triangle"),
                             Counted(static_cast<size_t>(plan.outer_rims), "outline"), out)
                 .c_str(),
             stdout);
  for (const std::string& w : PlanWarnings(plan)) std::fprintf(stderr, "tilemend: warning: %s\n", w.c_str());
  for (const LeftOpen& l : LeftOf(filled.report))
    std::fprintf(stderr, "left: %d edges: %s\n", static_cast<int>(l.edges), l.reason.c_str());
}

}  // namespace

int FillCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  FillOptions options;
  const std::string surface = args.Text("surface");
  if (surface != "wang" && surface != "thin-plate") {
    return PrintUsageError(
        absl::InvalidArgumentError(absl::StrCat("--surface '", surface, "': expected thin-plate or wang")));
  }
  options.surface = surface == "thin-plate" ? Surface::kThinPlate : Surface::kWang;
  const auto tension = TensionFromFlags(args);
  if (!tension.ok()) return PrintUsageError(tension.status());
  options.tension = *tension;
  if (*tension && surface != "thin-plate") {
    return PrintUsageError(absl::InvalidArgumentError("--tension: only the surface thin-plate has a tension"));
  }
  const auto gradation = args.Number("gradation", 1, 10);
  if (!gradation.ok()) return PrintUsageError(gradation.status());
  const auto size_limit = args.Number("size-limit", 1, 1e6);
  if (!size_limit.ok()) return PrintUsageError(size_limit.status());
  const auto water_tolerance = WaterToleranceFromFlags(args);
  if (!water_tolerance.ok()) return PrintUsageError(water_tolerance.status());
  options.refine.gradation = *gradation;
  options.refine.size_limit = *size_limit;
  options.refine.uniform = args.Switch("uniform");
  const std::string& in = args.arguments().front();
  const std::string out = args.Text("out");
  if (const absl::Status status = CheckPaths(in, out, args.Switch("overwrite")); !status.ok())
    return PrintError(status);
  const auto water = ReadWaterChoice(args.Text("water"), *water_tolerance);
  if (!water.ok()) return PrintError(water.status());
  MeshInspection mesh;
  auto filled = FillMesh(in, options, water->options, mesh);
  if (!filled.ok()) return PrintError(filled.status());
  Stopwatch watch;
  if (const absl::Status status = WriteFileAtomically(out, filled->bytes); !status.ok()) return PrintError(status);
  filled->report.seconds.emplace_back("write", watch.Lap());
  if (*format == OutputFormat::kJson) {
    std::fputs(SceneReport(filled->report).c_str(), stdout);
  } else {
    PrintSummary(*filled, out);
  }
  // Outlines of detached pieces and of the mesh itself are no holes: only holes that stay open make the result partial.
  const std::vector<LeftOpen> left = LeftOf(filled->report);
  const bool some_left =
      std::any_of(left.begin(), left.end(), [](const LeftOpen& l) { return l.is_hole; }) ||
      std::any_of(mesh.plan.holes.begin(), mesh.plan.holes.end(), [](const auto& h) { return !h.failure.empty(); });
  return some_left ? kExitSomeLeft : kExitDone;
}

}  // namespace tilemend
