#include "worker/papers/wang/wang_fill.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include "common/mesh/rounding.h"
#include "worker/fill/region/planar_region.h"
#include "worker/fill/shape/new_patch.h"
#include "worker/fill/shape/refine_patch.h"
#include "worker/papers/wang/adjust_patch.h"
#include "worker/papers/wang/closure_buffers.h"
#include "worker/papers/wang/cut_to_loops.h"
#include "worker/papers/wang/fair_patch.h"
#include "worker/papers/wang/grid_stretches.h"
#include "worker/papers/wang/minimum_area.h"

namespace tilemend {
namespace {

// Steps of the lattice. Rounding moves each corner of a triangle by half a step in x and y, and before that fairing may
// make it flatter.
constexpr double kLeastHeight_steps = 16;

using MayJoin = std::function<bool(int32_t, int32_t)>;

PatchSurroundings SurroundingsOf(const LocalHole& hole, const ProjectionFrame& frame, int32_t patch_size) {
  PatchSurroundings around;
  BandTriangles band = BandAt(hole, hole.has_equation, patch_size);
  for (const int32_t v : band.others) around.points.push_back(frame.ToFrame(hole.cell->band.points[v]));
  around.triangles = std::move(band.triangles);
  around.has_equation = hole.has_equation;
  return around;
}

NewPatch RimOf(const LocalHole& hole, const ProjectionFrame& frame) {
  NewPatch patch;
  patch.rim_count = hole.size();
  patch.sizes = hole.sizes;
  patch.least_height = kLeastHeight_steps * hole.cell->lattice_step;
  for (const Point3& p : hole.positions) patch.points.push_back(frame.ToFrame(p));
  for (const RegionSegment& s : hole.inner_edges) patch.fixed_edges.push_back(Undirected(s.from, s.to));
  std::sort(patch.fixed_edges.begin(), patch.fixed_edges.end());
  return patch;
}

// Refinement, adjustment, fairing.
bool Shape(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, const MayJoin& may_join,
           NewPatch& patch) {
  RefinePatch(options.refine, may_join, patch);
  const PatchSurroundings around = SurroundingsOf(hole, frame, patch.size());
  if (options.wang.adjust) AdjustPatch(around, patch);
  return FairPatch(around, options.wang.fairing_steps, patch, options.refine.is_cancelled);
}

// A loop on the plane, with what it bounds on the left.
class LoopCorners {
 public:
  LoopCorners(std::span<const int32_t> loop, std::span<const LatticePoint> places) {
    for (const int32_t v : loop) places_.push_back(places[v]);
  }

  // False if an edge from place i to place k begins outside: no triangulation whose triangles all turn left has it. It
  // may yet run outside farther on.
  bool Face(int32_t i, int32_t k) const {
    const auto n = static_cast<int32_t>(places_.size());
    const LatticePoint &before = places_[(i + n - 1) % n], &at = places_[i], &after = places_[(i + 1) % n];
    const auto into = Orientation(before, at, places_[k]), on = Orientation(at, after, places_[k]);
    if (Orientation(before, at, after) > 0) return into > 0 && on > 0;
    return into > 0 || on > 0 || (into == 0 && on == 0);
  }

 private:
  std::vector<LatticePoint> places_;
};

class WangFiller {
 public:
  WangFiller(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, bool may_repeat)
      : hole_(hole), frame_(frame), options_(options), patch_(RimOf(hole, frame)) {
    may_join_ = [this, may_repeat](int32_t a, int32_t b) { return may_repeat || hole_.MayJoin(a, b); };
    fixed_ = hole.segments;
    fixed_.insert(fixed_.end(), hole.inner_edges.begin(), hole.inner_edges.end());
    if (!hole.open || !frame.upright()) return;
    if (hole.own_outline) patch_.strips = StripsBeside(hole);
    if (may_repeat && options.wang.closure == Closure::kBuffers) AddBuffers();
  }

  LocalPatch Run() {
    LocalPatch result;
    result.failure = Triangulate(result.loop_cuts);
    if (!result.ok()) return result;
    if (!Shape(hole_, frame_, options_, may_join_, patch_)) return {FillFailure::kNoSolution};
    if (!Round()) return {FillFailure::kTurnsOver};
    for (int32_t v = hole_.size(); v < patch_.size(); ++v) result.new_points.push_back(InScene(v));
    result.triangles = std::move(patch_.triangles);
    return result;
  }

 private:
  // Their points are new ones, which adjustment and fairing move.
  void AddBuffers() {
    const ClosureBuffers buffers = LayClosureBuffers(hole_);
    for (const Point3& p : buffers.points) patch_.points.push_back(frame_.ToFrame(p));
    patch_.sizes.insert(patch_.sizes.end(), buffers.sizes.begin(), buffers.sizes.end());
    for (const RegionSegment& e : buffers.edges) {
      fixed_.insert(fixed_.end(), {e, {e.to, e.from}});
      patch_.fixed_edges.push_back(Undirected(e.from, e.to));
    }
    std::sort(patch_.fixed_edges.begin(), patch_.fixed_edges.end());
  }

  FillFailure Triangulate(int32_t& cuts) {
    std::vector<Point2> flat;
    for (const Point3& p : patch_.points) flat.emplace_back(p.head<2>());
    const std::vector<LatticePoint> places = RoundToWindow(flat, patch_.sizes).points;
    const RegionTriangulation region = TriangulateRegion(places, fixed_);
    if (!region.conflicts.empty()) {
      return hole_.open ? FillFailure::kCrossesSeenFromAbove : FillFailure::kCrossesOnItsPlane;
    }
    const CutRegion cut = CutToLoops(region, places, options_.wang.longest_loop);
    cuts = cut.cuts;
    for (const std::vector<int32_t>& loop : cut.loops) {
      if (options_.refine.cancelled()) return FillFailure::kNotApplicable;
      if (!TriangulateLoop(loop, places)) return FillFailure::kFlatTriangle;
    }
    return FillFailure::kNone;
  }

  bool TriangulateLoop(const std::vector<int32_t>& loop, std::span<const LatticePoint> places) {
    std::vector<Point3> positions;
    for (const int32_t v : loop) positions.push_back(patch_.points[v]);
    const auto turns_left = [&](int32_t i, int32_t j, int32_t k) {
      return Orientation(places[loop[i]], places[loop[j]], places[loop[k]]) > 0;
    };
    const LoopCorners corners(loop, places);
    const auto runs_inside = [&](int32_t i, int32_t k) { return corners.Face(i, k) && corners.Face(k, i); };
    std::vector<Triangle> triangles = TriangulateLeastArea(
        positions, [&](int32_t i, int32_t k) { return runs_inside(i, k) && may_join_(loop[i], loop[k]); }, turns_left,
        options_.refine.is_cancelled);
    // Edges that the surface has already are split by the refinement.
    if (triangles.empty()) {
      triangles = TriangulateLeastArea(positions, runs_inside, turns_left, options_.refine.is_cancelled);
    }
    for (const Triangle& t : triangles) patch_.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
    return !triangles.empty();
  }

  Point3 InScene(int32_t v) const {
    const Point3 p = frame_.ToScene(patch_.points[v]);
    Point3 rounded = RoundedToLattice(p, hole_.cell->lattice_step);
    if (frame_.upright()) rounded.head<2>() = p.head<2>();  // there already
    return rounded;
  }

  // Over the upright plane: puts new points where the output can hold them. Off it, triangles are checked in space.
  bool Round() {
    if (!frame_.upright()) return true;
    const NumberType type = hole_.cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64;
    const PointMover mover(patch_);
    for (int32_t v = hole_.size(); v < patch_.size(); ++v) {
      Point3& p = patch_.points[v];
      const Point2 exact = p.head<2>();
      p.head<2>() = RoundedTo(type, RoundedToLattice(exact, hole_.cell->lattice_step));
      if (mover.TurnsLeftAround(v)) continue;
      p.head<2>() = RoundedTo(type, exact);
      if (!mover.TurnsLeftAround(v)) return false;
    }
    return true;
  }

  const LocalHole& hole_;
  const ProjectionFrame& frame_;
  const FillOptions& options_;
  NewPatch patch_;
  std::vector<RegionSegment> fixed_;  // segments and edges inside
  MayJoin may_join_;
};

}  // namespace

LocalPatch FillAsWang(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                      bool may_repeat) {
  return WangFiller(hole, frame, options, may_repeat).Run();
}

LocalPatch ShapeAsWang(const LocalHole& hole, std::vector<Triangle> triangles, const FillOptions& options) {
  const ProjectionFrame scene = ProjectionFrame::Upright();
  NewPatch patch = RimOf(hole, scene);
  patch.projects = false;
  patch.triangles = std::move(triangles);
  const MayJoin may_join = [&](int32_t a, int32_t b) { return hole.MayJoin(a, b); };
  if (!Shape(hole, scene, options, may_join, patch)) return {FillFailure::kNoSolution};
  LocalPatch result;
  for (int32_t v = hole.size(); v < patch.size(); ++v) {
    result.new_points.push_back(RoundedToLattice(patch.points[v], hole.cell->lattice_step));
  }
  result.triangles = std::move(patch.triangles);
  return result;
}

}  // namespace tilemend
