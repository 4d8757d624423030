#include "worker/fill/plane/plane_fill.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "worker/fill/hole/facing.h"
#include "worker/fill/plane/upright_walls.h"
#include "worker/fill/region/planar_region.h"
#include "worker/fill/shape/flip_edges.h"
#include "worker/fill/shape/smooth_on_surface.h"

namespace tilemend {
namespace {

// Each gains less; a fourth one 0.001 of mean quality.
constexpr int kSurfaceRounds = 3;
constexpr int kSplitRounds = 8;  // each may bring up further edges; more than a few never came up

class PlaneFiller {
 public:
  PlaneFiller(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
              const PlaneFillOptions& plane_options)
      : hole_(hole), frame_(frame), options_(options), plane_options_(plane_options), fixed_edges_(hole.segments) {
    std::vector<Point2> flat;
    for (const Point3& p : hole.positions) {
      rim_.push_back(frame.ToFrame(p));
      flat.emplace_back(rim_.back().head<2>());
    }
    planar_.emplace(RoundToWindow(flat, hole.sizes));
    fixed_edges_.insert(fixed_edges_.end(), hole.inner_edges.begin(), hole.inner_edges.end());
  }

  LocalPatch Run() {
    RefinedRegion region;
    if (const FillFailure failure = Triangulate(region); failure != FillFailure::kNone) return {failure};
    PlanePatch patch = StartFrom(std::move(region));
    LocalPatch result;
    if (!FindHeights(hole_, frame_, options_, plane_options_.use, patch, result.hold_out)) {
      return {FillFailure::kNoSolution};
    }
    ImproveShapes(patch);
    planar_.reset();
    StorePoints(patch, result);
    result.triangles = std::move(patch.triangles);
    if (frame_.upright() && (hole_.own_outline || hole_.level)) {
      result.feet = RaiseWalls(hole_, HeightsAtRim(patch), result);
    }
    return result;
  }

 private:
  FillFailure Triangulate(RefinedRegion& region) {
    std::vector<LatticePoint>& points = planar_->points;
    region = RefineRegion(points, fixed_edges_, planar_->sizes, options_.refine);
    if (options_.refine.cancelled()) return FillFailure::kNotApplicable;
    if (std::ssize(region.new_points) >= options_.refine.max_new_points) return FillFailure::kTooLarge;
    if (!region.triangulation.conflicts.empty()) {
      return hole_.open ? FillFailure::kCrossesSeenFromAbove : FillFailure::kCrossesOnItsPlane;
    }
    if (plane_options_.at_folds) SplitRepeatedEdges(region);
    // Over a height field an edge is in the hole or on the surface.
    const bool may_repeat = hole_.open && !plane_options_.at_folds;
    if (!may_repeat && !RepeatedEdges(region.triangulation.triangles).empty()) return FillFailure::kRepeatsEdges;
    if (frame_.upright()) {
      MoveNewPoints(
          planar_->window,
          [&](const Point2& p) {
            return std::array<Point2, 2>{ToNumberType(RoundedToLattice(p, Step())), ToNumberType(p)};
          },
          points, fixed_edges_, region);
    }
    return FillFailure::kNone;
  }

  // The triangle edges between two rim vertices, none of the segments around the triangles, that the surface or the
  // hole's boundary has already.
  std::set<VertexPair> RepeatedEdges(const std::vector<Triangle>& triangles) const {
    std::vector<VertexPair> segments;
    for (const RegionSegment& s : hole_.segments) segments.push_back(Undirected(s.from, s.to));
    std::sort(segments.begin(), segments.end());
    std::set<VertexPair> repeated;
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        if (a > b || b >= hole_.size()) continue;
        if (std::binary_search(segments.begin(), segments.end(), VertexPair(a, b))) continue;
        if (!hole_.MayJoin(a, b)) repeated.insert({a, b});
      }
    }
    return repeated;
  }

  // Puts new points on such edges.
  void SplitRepeatedEdges(RefinedRegion& region) const {
    const std::vector<LatticePoint>& points = planar_->points;
    for (int round = 0; round < kSplitRounds; ++round) {
      const std::set<VertexPair> repeated = RepeatedEdges(region.triangulation.triangles);
      if (repeated.empty()) return;
      for (const auto& [a, b] : repeated) {
        region.new_points.push_back({(points[a].x + points[b].x) / 2, (points[a].y + points[b].y) / 2});
      }
      KeepNewPoints(std::vector<bool>(region.new_points.size(), true), points, fixed_edges_, region);
    }
  }

  // The patch before it has heights. The region is the largest piece of memory before the solve: it ends here.
  PlanePatch StartFrom(RefinedRegion region) {
    PlanePatch patch;
    patch.points.reserve(rim_.size() + region.new_points.size() + hole_.cell->band.points.size());
    patch.points = rim_;
    for (const LatticePoint& p : region.new_points) {
      const Point2 q = planar_->window.ToMetres(p);
      patch.points.emplace_back(q.x(), q.y(), 0);
    }
    planar_->points.insert(planar_->points.end(), region.new_points.begin(), region.new_points.end());
    patch.triangles = std::move(region.triangulation.triangles);
    patch.has_equation = hole_.has_equation;
    return patch;
  }

  // Better triangles in space, where good ones in the plane are poor on a steep surface: other diagonals and, with a
  // thin plate, new vertices moved along the surface.
  void ImproveShapes(PlanePatch& patch) {
    const auto flip = [&] {
      patch.triangles =
          FlipForShape(patch.triangles, planar_->points, patch.points, fixed_edges_, [&](int32_t a, int32_t b) {
            const bool both_on_rim = a < hole_.size() && b < hole_.size();
            return !both_on_rim || hole_.MayJoin(a, b);
          });
    };
    flip();
    if (hole_.level || options_.surface != Surface::kThinPlate) return;
    const PlacePoint place = [&](const Point2& p) { return PlaceInWindow(p); };
    for (int round = 0; round < kSurfaceRounds && IsSteepPatch(patch.triangles, patch.points); ++round) {
      SmoothOnSurface(patch.triangles, hole_.size(), place, planar_->points, patch.points);
      flip();
    }
  }

  // The place nearest to p where a new vertex can be.
  std::optional<std::pair<LatticePoint, Point2>> PlaceInWindow(const Point2& p) const {
    const Point2 wanted = frame_.upright() ? ToNumberType(RoundedToLattice(p, Step())) : p;
    const LatticePoint near = planar_->window.Round(wanted);
    const Point2 there = planar_->window.ToMetres(near);
    if (frame_.upright() && there != wanted) return std::nullopt;
    return std::pair(near, there);
  }

  void StorePoints(const PlanePatch& patch, LocalPatch& result) const {
    result.new_points.reserve(patch.points.size() - rim_.size());
    for (size_t v = rim_.size(); v < patch.points.size(); ++v) {
      const Point3 p = frame_.ToScene(patch.points[v]);
      Point3& q = result.new_points.emplace_back(RoundedToLattice(p, Step()));
      if (frame_.upright()) q.head<2>() = p.head<2>();  // there already
    }
  }

  std::vector<double> HeightsAtRim(const PlanePatch& patch) const {
    std::vector<double> heights;
    for (size_t v = 0; v < rim_.size(); ++v) heights.push_back(patch.points[v].z());
    return heights;
  }

  double Step() const { return hole_.cell->lattice_step; }

  Point2 ToNumberType(const Point2& p) const {
    return RoundedTo(hole_.cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64, p);
  }

  const LocalHole& hole_;
  const ProjectionFrame& frame_;
  const FillOptions& options_;
  const PlaneFillOptions& plane_options_;
  std::vector<RegionSegment> fixed_edges_;  // segments and inner edges
  std::vector<Point3> rim_;                 // in the frame
  std::optional<PlanarPoints> planar_;      // the rim's, then the new points
};

}  // namespace

LocalPatch FillOverPlane(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                         const PlaneFillOptions& plane_options) {
  if (options.surface == Surface::kWang && !hole.level) {
    return options.published->over_plane(hole, frame, options, hole.open && !plane_options.at_folds);
  }
  return PlaneFiller(hole, frame, options, plane_options).Run();
}

LocalPatch FillOverFacingPlane(const LocalHole& hole, const FillOptions& options) {
  for (const Eigen::Vector3d& normal : {FacingOf(hole), hole.VectorArea(), WidestView(hole)}) {
    if (normal.isZero()) continue;
    LocalPatch patch = FillOverPlane(hole, FrameAcross(hole, normal), options, {RimUse::kPart});
    if (patch.ok()) return patch;
  }
  return {FillFailure::kNotApplicable};
}

}  // namespace tilemend
