// `tilemend fill`: the holes of one mesh, without a grid.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/commands.h"
#include "client/inspection.h"
#include "client/job_flags.h"
#include "client/output.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "coordinator/plan/cell_work.h"
#include "coordinator/service/scene_report.h"
#include "worker/assemble/assemble.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {
namespace {

absl::Status CheckOutput(const std::string& in, const std::string& out, bool overwrite) {
  std::error_code error;
  if (std::filesystem::equivalent(in, out, error) && !error) {
    return absl::InvalidArgumentError(
        absl::StrCat(out, ": the output would be written over the input; choose another --out"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat from, MeshFormatOf(in));
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat to, MeshFormatOf(out));
  if (from != to)
    return absl::InvalidArgumentError(absl::StrCat(out, ": the output has the format of the input: ", in));
  if (std::filesystem::is_directory(out, error)) {
    return absl::InvalidArgumentError(absl::StrCat(out, ": the output is a folder; choose another --out"));
  }
  if (!overwrite && std::filesystem::exists(out, error)) {
    return absl::AlreadyExistsError(absl::StrCat(out, ": is there already; choose another --out, or give --overwrite"));
  }
  return absl::OkStatus();
}

struct Filled {
  SceneReportInput report;
  std::string bytes;
};

absl::StatusOr<Filled> FillMesh(const std::string& path, const FillOptions& options, MeshInspection& mesh) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path));
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ParseMesh(format, bytes, path));
  InspectMesh(file, {options.refine.gradation, options.refine.size_limit, options.refine.uniform}, mesh);
  Filled filled;
  filled.report.plan = &mesh.plan;
  filled.report.cells = 1;
  filled.report.surface = options.surface == Surface::kThinPlate ? "thin-plate" : "wang";
  FilePatch patch;
  std::vector<int32_t> holes;
  for (size_t h = 0; h < mesh.plan.holes.size(); ++h) {
    if (mesh.plan.holes[h].failure.empty()) holes.push_back(static_cast<int32_t>(h));
  }
  if (!holes.empty()) {
    const CellHoles work = MakeCellHoles(mesh.plan, mesh.input, SeamHeights(), holes, true);
    const std::vector<HolePatch> patches = FillHoles(work, options);
    for (const HolePatch& p : patches) {
      if (!p.failure.empty()) filled.report.failures[p.hole] = p.failure;
      filled.report.sizes[p.hole] = {p.new_points.size(), p.triangles.size()};
    }
    patch = MergePatches(work.vertices, patches, work.cell, static_cast<int32_t>(file.mesh.points.size()));
  }
  if (patch.triangles.empty()) {
    filled.bytes = bytes;
  } else {
    TILEMEND_ASSIGN_OR_RETURN(filled.bytes, AppendPatch(format, bytes, patch, path));
  }
  return filled;
}

void PrintSummary(const Filled& filled, const std::string& out) {
  const Plan& plan = *filled.report.plan;
  int64_t vertices = 0, triangles = 0;
  for (const auto& [hole, size] : filled.report.sizes) {
    vertices += size.first;
    triangles += size.second;
  }
  std::fputs(
      absl::StrFormat("%d of %d holes filled with %d new vertices and %d triangles; %d outer rims\nwritten: %s\n",
                      plan.holes.size() - filled.report.failures.size(), plan.holes.size(), vertices, triangles,
                      plan.outer_rims, out)
          .c_str(),
      stdout);
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
        absl::InvalidArgumentError(absl::StrCat("--surface '", surface, "': expected wang or thin-plate")));
  }
  if (surface == "thin-plate") options.surface = Surface::kThinPlate;
  const auto tension = args.Number("tension", 0, 1000);
  if (!tension.ok()) return PrintUsageError(tension.status());
  options.tension = *tension;
  const auto gradation = args.Number("gradation", 1, 10);
  if (!gradation.ok()) return PrintUsageError(gradation.status());
  const auto size_limit = args.Number("size-limit", 1, 1e6);
  if (!size_limit.ok()) return PrintUsageError(size_limit.status());
  options.refine.gradation = *gradation;
  options.refine.size_limit = *size_limit;
  options.refine.uniform = args.Switch("uniform");
  const std::string& in = args.arguments().front();
  const std::string out = args.Text("out");
  if (const absl::Status status = CheckOutput(in, out, args.Switch("overwrite")); !status.ok())
    return PrintError(status);
  MeshInspection mesh;
  const auto filled = FillMesh(in, options, mesh);
  if (!filled.ok()) return PrintError(filled.status());
  if (const absl::Status status = WriteFileAtomically(out, filled->bytes); !status.ok()) return PrintError(status);
  if (*format == OutputFormat::kJson) {
    std::fputs(SceneReport(filled->report).c_str(), stdout);
  } else {
    PrintSummary(*filled, out);
  }
  // Outlines of detached pieces and of the mesh itself are no holes: only holes that stay open make the result partial.
  const bool some_left =
      !filled->report.failures.empty() ||
      std::any_of(mesh.plan.holes.begin(), mesh.plan.holes.end(), [](const auto& h) { return !h.failure.empty(); });
  return some_left ? kExitSomeLeft : kExitDone;
}

}  // namespace tilemend
