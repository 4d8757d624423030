#include "client/mesh/mesh_filler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/mesh/file_mesh.h"
#include "client/mesh/single_mesh.h"
#include "common/assemble/assemble.h"
#include "common/mesh/height_tallies.h"
#include "common/mesh/mesh_limits.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "worker/check/mesh_defects.h"
#include "worker/fill/shape/patch_quality.h"
#include "worker/fill/space/surface_index.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

// Of the length of an edge. Coordinates that are rounded to more turn a triangle by more than half a degree.
constexpr double kCoarseStep = 0.01;

// Does the work on one mesh, one piece after the other.
class MeshFiller {
 public:
  MeshFiller(EditedMesh& mesh, const MeshFillOptions& options)
      : mesh_(mesh), options_(options.fill), weld_(options.weld), library_(options.library), show_(options.show) {
    options_.published = AllPublishedWays();
    options_.refine.max_new_points = kMaxSingleMeshPoints;
    options_.is_single_mesh = true;
    WaveOptions waves;
    waves.plan = {.gradation = options_.refine.gradation,
                  .size_limit = options_.refine.size_limit,
                  .uniform = options_.refine.uniform,
                  .water = options.water,
                  .mesh = options.holes,
                  .water_colour = options.water_colour,
                  .is_cancelled = options_.refine.is_cancelled};
    waves.surface = options_.surface;
    waves.single_mesh = true;
    filled_.waves = std::make_unique<SceneWaves>(SceneOfMesh(mesh.name()), std::move(waves),
                                                 [this](std::string_view step) { EndStep(step); });
  }

  absl::StatusOr<FilledMesh> Fill() {
    TILEMEND_RETURN_IF_ERROR(Read());
    while (const std::optional<SceneWork> work = filled_.waves->Next()) {
      TILEMEND_RETURN_IF_ERROR(CheckNotCancelled());
      TILEMEND_RETURN_IF_ERROR(std::visit([this](const auto& w) { return Do(w); }, *work));
    }
    TILEMEND_RETURN_IF_ERROR(CheckNotCancelled());  // a plan that was cancelled is empty
    SceneReportInput& report = filled_.report;
    report.plan = &filled_.waves->plan();
    report.outcome = filled_.waves->outcome();
    report.cells = 1;
    report.scene = mesh_.name();
    if (report.plan->holes.empty()) TILEMEND_RETURN_IF_ERROR(WarnOfNoSurface());
    return std::move(filled_);
  }

 private:
  absl::Status Read() {
    if (weld_) TILEMEND_RETURN_IF_ERROR(WeldRimsWithin(*weld_));
    TILEMEND_ASSIGN_OR_RETURN(survey_, mesh_.Survey(NoFaces::kRefuse));
    filled_.files = std::move(survey_.files);
    if (survey_.record.copied_triangles > 0) {
      filled_.report.warnings.push_back(
          absl::StrCat(mesh_.name(), ": ", survey_.record.copied_triangles,
                       " of its faces are copies of others; holes were found and filled as if each were there once"));
    }
    WarnOfTurnedFaces();
    WarnOfCoarseNumbers();
    EndStep("read");
    show_("find holes", 0, 0);
    return CheckNotCancelled();
  }

  void WarnOfTurnedFaces() {
    const int64_t turned = survey_.record.turned_triangles, left = survey_.record.disagreeing_edges;
    if (turned > 0) {
      filled_.report.warnings.push_back(
          absl::StrCat(mesh_.name(), ": ", turned, " of its ", survey_.record.triangle_count,
                       " faces are turned the other way than most around them; holes were found and filled as if they "
                       "were turned back, and the output keeps these faces as they are"));
    }
    if (left > 0) {
      filled_.report.warnings.push_back(absl::StrCat(
          mesh_.name(), ": at ", left,
          " edges the two faces are turned opposite ways, and the surface there has one side only; orient its faces"));
    }
  }

  void WarnOfCoarseNumbers() {
    const SurveyRecord& record = survey_.record;
    if (!record.float32 || record.edges.empty()) return;
    const double largest = std::max(record.lo.cwiseAbs().maxCoeff(), record.hi.cwiseAbs().maxCoeff());
    const float number = static_cast<float>(largest);
    const double step = std::nextafter(number, std::numeric_limits<float>::infinity()) - number;
    double length = 0;
    for (const BoundaryEdge& edge : record.edges) {
      length += (record.vertices[edge.to].position - record.vertices[edge.from].position).norm();
    }
    length /= static_cast<double>(record.edges.size());
    if (step <= kCoarseStep * length) return;
    filled_.report.warnings.push_back(absl::StrFormat(
        "%s: its coordinates are single-precision numbers, %g apart at their size, and its edges at holes are %.2g "
        "long: "
        "shapes are not finer than that; give double precision, or take an offset off the coordinates before they are "
        "rounded",
        mesh_.name(), step, length));
  }

  // A mesh of needles alone has no hole, and nothing else either.
  absl::Status WarnOfNoSurface() {
    TILEMEND_ASSIGN_OR_RETURN(const HeldMesh mesh, mesh_.Mesh());
    if (HasArea(mesh.view)) return absl::OkStatus();
    filled_.report.warnings.push_back(
        absl::StrCat(mesh_.name(), ": none of its ", mesh.view.triangles.size(),
                     " triangles has an area: there is no surface that could have holes"));
    return absl::OkStatus();
  }

  absl::Status WeldRimsWithin(double tolerance) {
    show_("weld", 0, 0);
    TILEMEND_ASSIGN_OR_RETURN(filled_.report.weld, mesh_.Weld(tolerance));
    EndStep("weld");
    return CheckNotCancelled();
  }

  absl::Status Do(const MeasureWork& work) {
    TILEMEND_ASSIGN_OR_RETURN(const HeldMesh mesh, mesh_.Mesh());
    TileLevels levels{work.tile->cell, {}};
    levels.tallies = TallyHeightsIn(mesh.view, work.polygons);
    return filled_.waves->Take(std::move(levels));
  }

  absl::Status Do(const SurveyWork& work) {
    std::vector<int64_t> cleared;
    if (!work.clear.empty()) {
      TILEMEND_ASSIGN_OR_RETURN(cleared, mesh_.Clear(work.clear));
      TILEMEND_ASSIGN_OR_RETURN(survey_, mesh_.Survey(NoFaces::kAccept));
    }
    return filled_.waves->Take(SurveyInMemory(work.tile->cell, std::move(survey_.record), std::move(cleared)));
  }

  absl::Status Do(const FillWork& work) {
    std::optional<absl::StatusOr<HeldMesh>> mesh;  // for holes that are no heights over the ground
    std::optional<SurfaceIndex> surface;
    const auto near = [&](const Point3& lo, const Point3& hi) {
      std::vector<SpaceTriangle> found;
      if (!mesh) {
        mesh = mesh_.Mesh();
        if (mesh->ok()) surface.emplace((*mesh)->view);
      }
      if (surface) surface->AppendNear(lo, hi, found);
      return found;
    };
    const size_t holes = work.holes.holes.size();
    size_t done = 0;
    show_("fill", done, holes);
    const std::vector<HolePatch> patches = FillHoles(work.holes, options_, near, [&] { show_("fill", ++done, holes); });
    if (mesh) TILEMEND_RETURN_IF_ERROR(mesh->status());
    TILEMEND_RETURN_IF_ERROR(CheckNotCancelled());
    rim_ = work.holes.vertices;
    patches_ = patches;
    return filled_.waves->Take(CellFill{work.holes.cell, {ExtentsOf(patches), TallyQuality(work.holes, patches)}});
  }

  absl::Status Do(const AssembleWork& work) {
    FilePatch patch =
        MergePatches(rim_, patches_, work.tile->cell, static_cast<int32_t>(work.tile_vertices), work.colours);
    if (!patch.triangles.empty()) {
      filled_.materials = MaterialsOf(patches_, work.colours);
      patch.library = library_;
      TILEMEND_RETURN_IF_ERROR(mesh_.Append(patch));
    }
    return filled_.waves->Take(TileWritten{});
  }

  absl::Status Do(const GroundWork&) { return NoSeams(); }
  absl::Status Do(const ClusterWork&) { return NoSeams(); }
  absl::Status Do(const LayerWork&) { return NoSeams(); }
  absl::Status Do(const SmoothWork&) { return NoSeams(); }
  static absl::Status NoSeams() { return absl::InternalError("a mesh without a grid has neither objects nor seams"); }

  absl::Status CheckNotCancelled() const {
    return options_.refine.cancelled() ? absl::CancelledError("cancelled") : absl::OkStatus();
  }

  static std::vector<PatchExtent> ExtentsOf(const std::vector<HolePatch>& patches) {
    std::vector<PatchExtent> extents;
    for (const HolePatch& p : patches) {
      extents.push_back({p.hole, p.failure, static_cast<int64_t>(p.new_points.size()),
                         static_cast<int64_t>(p.triangles.size()), p.hold_out, p.way, p.loop_cuts, p.creases,
                         p.rim_is_crossed});
    }
    return extents;
  }

  // "survey" is told with the plan.
  void EndStep(std::string_view step) {
    if (step == "survey" || step == "ground" || step == "sample") return;
    filled_.report.seconds.emplace_back(step == "plan" ? "survey" : step, watch_.Lap());
  }

  EditedMesh& mesh_;
  FillOptions options_;
  const std::optional<double> weld_;
  const std::string library_;
  const ShowStep show_;
  Stopwatch watch_;
  FilledMesh filled_;
  LookSurvey survey_;           // until it is taken
  std::vector<RimVertex> rim_;  // of all holes
  std::vector<HolePatch> patches_;
};

}  // namespace

absl::StatusOr<FilledMesh> FillMesh(EditedMesh& mesh, const MeshFillOptions& options) {
  return MeshFiller(mesh, options).Fill();
}

absl::StatusOr<FilledMesh> FillMesh(const std::string& path, const MeshFillOptions& options) {
  KeepHeap(1);
  options.show("read", 0, 0);
  TILEMEND_ASSIGN_OR_RETURN(FileMesh mesh, FileMesh::Open(path));
  TILEMEND_ASSIGN_OR_RETURN(FilledMesh filled, FillMesh(mesh, options));
  if (mesh.format() != MeshFormat::kObj) filled.materials.clear();  // other formats name none
  filled.bytes = mesh.TakeBytes();
  return filled;
}

}  // namespace tilemend
