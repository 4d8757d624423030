#include "worker/papers/front/front_fill.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "worker/papers/front/advancing_front.h"
#include "worker/papers/front/curvature_patch.h"
#include "worker/papers/front/front_rules.h"
#include "worker/papers/front/poisson_patch.h"
#include "worker/papers/front/split_rim.h"
#include "worker/papers/front/svm_patch.h"

namespace tilemend {
namespace {

// A disc of even triangles needs a third of this. A front that needs more runs away.
int64_t MostNewPoints(int64_t edges) { return edges * edges / 3 + 200; }

// A front that closes gets shorter; over a folded boundary it grows a little at first.
int64_t LongestFront(int64_t edges) { return 2 * edges + 100; }

// FillerOptions::most_work is in millions.
constexpr int64_t kWorkUnit = 1'000'000;

FrontRim RimOf(const LocalHole& hole) {
  FrontRim rim;
  rim.points = hole.positions;
  rim.sizes = hole.sizes;
  for (const RimLoop& loop : hole.loops) rim.loops.push_back(loop.vertices);
  const TriMesh& band = hole.cell->band;
  for (const int32_t v : hole.vertices) {
    Eigen::Vector3d& area = rim.areas.emplace_back(Eigen::Vector3d::Zero());
    std::vector<int32_t> ring;
    for (const int32_t t : hole.band->At(v)) {
      area += hole.band->Normal(t);
      for (const int32_t w : band.triangles[t]) {
        if (w != v) ring.push_back(w);
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    std::vector<Point3>& neighbours = rim.neighbours.emplace_back();
    for (const int32_t w : ring) neighbours.push_back(band.points[w]);
  }
  const int32_t own = hole.size();
  rim.may_join = [&hole, own](int32_t a, int32_t b) { return a >= own || b >= own || hole.MayJoin(a, b); };
  return rim;
}

double MeanEdge(const LocalHole& hole) {
  double sum = 0;
  for (const RegionSegment& s : hole.segments) sum += (hole.positions[s.to] - hole.positions[s.from]).norm();
  return sum / static_cast<double>(hole.segments.size());
}

RimSurface SurfaceAtRim(const LocalHole& hole) {
  BandTriangles band = BandAt(hole, std::vector<bool>(hole.vertices.size(), true), hole.size());
  RimSurface surface{hole.positions, std::move(band.triangles)};
  for (const int32_t v : band.others) surface.points.push_back(hole.cell->band.points[v]);
  return surface;
}

class FrontFiller {
 public:
  FrontFiller(const LocalHole& hole, const FillOptions& options) : hole_(hole), options_(options), rim_(RimOf(hole)) {}

  LocalPatch ByNormals() {
    Advance(NormalCurvatureRule(options_.filling.bend, options_.filling.steps));
    return Result();
  }

  LocalPatch ByPoisson() {
    Advance(PlainRule(options_.filling.steps));
    if (front_.closed() && !ShapeByNormals(rim_.areas, front_.triangles, front_.points)) {
      return {FillFailure::kNoSolution};
    }
    return Result();
  }

  LocalPatch BySvm(std::span<const SpaceTriangle> surface) {
    const double edge = MeanEdge(hole_);
    const int32_t split = SplitLongEdges(options_.filling.long_edge * edge, rim_);
    Advance(PlainRule(options_.filling.steps));
    if (!front_.closed()) return Result();
    const std::vector<LaplacianSample> samples =
        SampleRings(hole_.positions, surface, options_.filling.rings, options_.filling.scale);
    if (!ShapeByLaplacians(samples, options_.filling, edge, front_.triangles, hole_.size() + split, front_.points)) {
      return {FillFailure::kNoSolution};
    }
    if (!TieBack(hole_.size(), split, rim_.may_join, front_)) return {FillFailure::kNotClosed};
    return Result();
  }

  LocalPatch ByCurvature() {
    Advance(PlainRule(options_.filling.steps));
    if (!front_.closed()) return Result();
    CurvaturePatch patch{std::move(front_.points), hole_.size(), std::move(front_.triangles)};
    RefineByCurvature(SurfaceAtRim(hole_), options_.filling, rim_.may_join, patch);
    front_.points = std::move(patch.points);
    front_.triangles = std::move(patch.triangles);
    return Result();
  }

 private:
  void Advance(const FrontRule& rule) {
    const int64_t edges = std::ssize(rim_.points);
    const FrontLimits limits = {options_.filling.steps == FrontSteps::kPrinted,
                                options_.filling.merge,
                                std::min(options_.refine.max_new_points, MostNewPoints(edges)),
                                LongestFront(edges),
                                options_.filling.most_work * kWorkUnit,
                                options_.refine.is_cancelled};
    front_ = AdvanceFront(rim_, rule, limits);
  }

  LocalPatch Result() {
    if (front_.end == FrontEnd::kTooMuchWork) return {FillFailure::kTooMuchWork};
    if (!front_.closed()) return {FillFailure::kFrontOpen};
    LocalPatch patch;
    for (size_t v = hole_.positions.size(); v < front_.points.size(); ++v) {
      patch.new_points.push_back(RoundedToLattice(front_.points[v], hole_.cell->lattice_step));
    }
    patch.triangles = std::move(front_.triangles);
    return patch;
  }

  const LocalHole& hole_;
  const FillOptions& options_;
  FrontRim rim_;
  FrontPatch front_;
};

}  // namespace

LocalPatch FillWithFront(const LocalHole& hole, const FillOptions& options,
                         const std::function<std::span<const SpaceTriangle>()>& surface) {
  if (hole.loops.empty()) return {FillFailure::kNotClosed};
  if (std::ssize(hole.segments) > options.filling.longest_rim) return {FillFailure::kTooLongForFront};
  FrontFiller filler(hole, options);
  switch (options.filler) {
    case Filler::kAdvancingFrontNormal:
      return filler.ByNormals();
    case Filler::kAdvancingFrontPoisson:
      return filler.ByPoisson();
    case Filler::kSvmLaplacian:
      return filler.BySvm(surface());
    case Filler::kAdvancingFrontCurvature:
      return filler.ByCurvature();
    case Filler::kAuto:
    case Filler::kMinimumArea:
      break;
  }
  return {FillFailure::kNotApplicable};
}

}  // namespace tilemend
