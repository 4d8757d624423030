#include "coordinator/plan/mesh/plan_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "coordinator/plan/hole/measure_hole.h"
#include "coordinator/plan/hole/planar_regions.h"
#include "coordinator/plan/mesh/loop_groups.h"
#include "coordinator/plan/mesh/mesh_loops.h"
#include "coordinator/plan/mesh/outlines.h"
#include "coordinator/plan/rim/rim_sizes.h"
#include "coordinator/plan/types/left_reasons.h"

namespace tilemend {
namespace {

// The lattice is so much finer than the mean edge along the holes: rounding to it tilts no triangle that is seen.
constexpr double kStepsAnEdge = 0x1p20;
// Of the area of a flat piece: rounding.
constexpr double kFlat = 1e-9;
// Where surface meets that is turned over, as on a Moebius strip, the boundary changes its direction.
constexpr char kNoLoop[] =
    "boundary edges that form no loop: the surface is not manifold there, or faces beside each other are turned "
    "opposite ways";
constexpr int kFloat32Digits = 24, kFloat64Digits = 53;

// The finest useful power of two whose multiples the mesh's number type holds out to its farthest coordinate.
double LatticeStep(const SurveyRecord& record, const Rim& rim) {
  double length = 0, farthest = 0;
  for (const RimEdge& e : rim.edges) length += (rim.points[e.to].position - rim.points[e.from].position).norm();
  if (length > 0) length /= static_cast<double>(rim.edges.size());
  if (record.vertex_count > 0) {
    farthest = std::max(record.lo.cwiseAbs().maxCoeff(), record.hi.cwiseAbs().maxCoeff());
  }
  const auto power = [](double x) { return x > 0 ? std::ldexp(1.0, std::ilogb(x)) : 0.0; };
  const double holds = power(farthest) * std::ldexp(2.0, -(record.float32 ? kFloat32Digits : kFloat64Digits));
  const double step = std::max(holds, power(length) / kStepsAnEdge);
  return step > 0 ? step : 1;
}

DislocationLimit DislocationLimitOf(const MeshHoleOptions& options) {
  DislocationLimit limit;
  limit.length = options.dislocation_width.value_or(limit.length);
  return limit;
}

class MeshPlanner {
 public:
  MeshPlanner(const PlanInput& input, const PlanOptions& options)
      : cell_(input.cells.begin()->first), record_(input.cells.begin()->second.Outline()), options_(options) {
    rim_ = BuildRim(input, RimPoints::kOfEdges);
    LinkLoops(rim_, record_->edge_after);
    plan_.lattice_step = LatticeStep(*record_, rim_);
    plan_.single_mesh = true;
    plan_.upright = options.water.find || !options.water.areas.empty();
  }

  Plan Run() {
    loops_ = ReadMeshLoops(rim_, *record_);
    plan_.continuous = CountContinuous(loops_);
    open_.assign(record_->piece_areas.size(), Eigen::Vector3d::Zero());
    for (const MeshLoop& loop : loops_) open_[loop.piece] += loop.vector_area;
    StoreVertices();
    const LoopGroups groups = Group();
    for (const MeshHole& hole : groups.holes) StoreHole(hole);
    plan_.outer_rims = std::ssize(groups.outlines);
    for (const size_t l : groups.outlines) Leave("outline of a piece of surface", loops_[l].segments.size(), false);
    if (!rim_.unlinked.empty()) {
      Leave(kNoLoop, rim_.unlinked.size(), true);
      plan_.left.back().at = rim_.points[rim_.edges[rim_.unlinked.front()].from].position;
    }
    if (record_->repeated_edges > 0) {
      Leave("edges of faces that occur more than once, as copies or as front and back: remove all but one of each",
            static_cast<size_t>(record_->repeated_edges), true);
    }
    return std::move(plan_);
  }

 private:
  // Outlines that are to be filled are holes, but for those of islands: these are parts of the holes that they lie in.
  LoopGroups Group() const {
    const DislocationLimit dislocation = DislocationLimitOf(options_.mesh);
    std::vector<bool> outline = FindOutlines(loops_, record_->piece_areas);
    LoopGroups groups = GroupLoops(rim_, loops_, outline, dislocation);
    if (!options_.mesh.fill_outlines) return groups;
    for (const size_t l : groups.outlines) outline[l] = false;
    return GroupLoops(rim_, loops_, outline, dislocation);
  }

  void StoreVertices() {
    RaiseSmallSizes(plan_.lattice_step, rim_);
    RaiseSizesAtShortEdges(rim_);
    for (const RimPoint& p : rim_.points) {
      plan_.vertices.push_back({p.tile, p.index, p.position, p.centroid_height, p.size});
      position_.push_back(p.position);
    }
    plan_.vertex_of_boundary = rim_.point_of;
  }

  void StoreHole(const MeshHole& found) {
    std::vector<RimSegment> segments = loops_[found.loop].segments;
    Eigen::Vector3d area = loops_[found.loop].vector_area;
    for (const size_t l : found.others) {
      segments.insert(segments.end(), loops_[l].segments.begin(), loops_[l].segments.end());
      area += loops_[l].vector_area;
    }
    if (found.others.empty() && IsFlatOutline(loops_[found.loop])) {
      return Leave("outline of a flat piece: its patch would lie on it", segments.size(), true);
    }
    if (options_.mesh.largest_hole && std::ssize(segments) > *options_.mesh.largest_hole) {
      return Leave(kLongerThanChosen, segments.size(), false);
    }
    PlannedHole hole = MeasureHole(cell_, std::move(segments), position_);
    hole.single = found.single;
    hole.continuous = loops_[found.loop].touches;
    hole.area = area.norm();
    if (hole.single == SingleType::kAnnular) hole.area = AreaOfBand(loops_[found.loop], loops_[found.others.front()]);
    hole.projects = plan_.upright && ProjectsUpright(hole.segments);
    plan_.holes.push_back(std::move(hole));
  }

  // About: of a round tube that ends in such loops. Their vector areas together cancel each other.
  static double AreaOfBand(const MeshLoop& a, const MeshLoop& b) {
    const auto around = [](const MeshLoop& loop) { return 2 * std::sqrt(std::numbers::pi * loop.vector_area.norm()); };
    return (around(a) + around(b)) / 2 * (a.middle - b.middle).norm();
  }

  // Whether a loop runs around a piece of surface that is flat: as large as the vector area of all its loops (Stokes).
  bool IsFlatOutline(const MeshLoop& loop) const {
    if (loop.Turn() >= 0 || loop.IsSlit()) return false;
    return record_->piece_areas[loop.piece] <= (1 + kFlat) * open_[loop.piece].norm();
  }

  // Whether the surface along a hole faces up and the hole is one region seen from above.
  bool ProjectsUpright(const std::vector<RimSegment>& segments) const {
    const bool faces_up = std::all_of(segments.begin(), segments.end(),
                                      [&](const RimSegment& s) { return rim_.points[s.from].normal.z() > 0; });
    return faces_up && FindPlanarRegions(segments, position_, options_.is_cancelled).triangulation.component_count == 1;
  }

  void Leave(const char* reason, size_t edges, bool is_hole) {
    plan_.left.push_back({cell_, reason, -1, static_cast<int64_t>(edges), is_hole});
  }

  const CellId cell_;
  const StoredRecord::Pointer record_;
  const PlanOptions& options_;
  Rim rim_;
  std::vector<MeshLoop> loops_;
  std::vector<Eigen::Vector3d> open_;  // by piece: the vector area of its loops
  std::vector<Point3> position_;       // of rim points
  Plan plan_;
};

}  // namespace

Plan PlanMesh(const PlanInput& input, const PlanOptions& options) { return MeshPlanner(input, options).Run(); }

}  // namespace tilemend
