#include "common/assemble/level_outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "common/mesh/segment_distance.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

// How far rounding moves a corner from its edge, in steps of the lattice: by less than one in each step that makes the
// region.
constexpr double kRounding = 8;

// The region reaches an edge beyond the finest patch.
constexpr double kReachInEdges = 2;

// The median edge of triangles seen from above, metres.
double EdgeOf(const TriMesh& mesh, const std::vector<Triangle>& triangles) {
  std::vector<double> lengths;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) lengths.push_back((mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).head<2>().norm());
  }
  return MedianOf(std::move(lengths));
}

std::vector<SpaceTriangle> CornersOf(const FilePatch& patch, const FinestPatch& finest) {
  std::vector<SpaceTriangle> corners;
  for (const Triangle& t : patch.triangles) corners.push_back({finest.At(t[0]), finest.At(t[1]), finest.At(t[2])});
  return corners;
}

// Around all that the triangles cover.
SurfaceOutline OutlineFromAbove(const TriMesh& mesh, std::vector<Triangle> triangles) {
  return SurfaceOutlineOf(FacingUp(mesh, std::move(triangles)), [&](int32_t v) { return mesh.points[v]; });
}

}  // namespace

LevelOutline::LevelOutline(const TriMesh& level, const TriMesh& finest, const FilePatch& patch, const TriMesh& cleared)
    : patch_(patch),
      cleared_(cleared),
      finest_patch_(finest, patch),
      on_patch_(CornersOf(patch, finest_patch_)),
      on_cleared_(CornersOf(cleared)),
      edge_(EdgeBeside(level)),
      level_outline_(OutlineNear(level)),
      cleared_outline_(OutlineFromAbove(cleared, cleared.triangles)),
      patch_outline_(SurfaceOutlineOf(patch.triangles, [&](int32_t v) { return finest_patch_.At(v); })),
      seen_outline_(OutlineFromAbove(finest, HasCleared() ? TrianglesNear(finest) : std::vector<Triangle>{})),
      finest_outline_(OutlineNear(finest)),
      region_(Window()) {}

int32_t LevelOutline::LevelVertexAt(int32_t v) const {
  return v < std::ssize(level_outline_.vertex) ? level_outline_.vertex[v] : -1;
}

const Point3* LevelOutline::PlaceOf(int32_t v) const {
  for (const auto& [first, outline] : placed_) {
    if (v >= first && v < first + std::ssize(outline->positions)) return &outline->positions[v - first];
  }
  return nullptr;
}

std::vector<RegionBoundary> LevelOutline::Boundaries() {
  const std::vector<RegionLoop> loops = Loops();
  if (loops.empty()) return {};
  VertexThinning thinning(1, edge_);
  std::vector<RegionLoop> thinned;
  for (const RegionLoop& loop : loops) thinned.push_back(Thinned(loop, thinning));
  if (RegionBoundary all = SegmentsOf(thinned); IsBoundary(all)) return {std::move(all)};
  std::vector<RegionBoundary> boundaries;
  for (const std::vector<int32_t>& hole : region_.HolesOf(loops)) {
    std::vector<RegionLoop> whole, less;
    for (const int32_t i : hole) {
      whole.push_back(loops[static_cast<size_t>(i)]);
      less.push_back(thinned[static_cast<size_t>(i)]);
    }
    if (auto boundary = BoundaryOf(whole, less)) {
      boundaries.push_back(*std::move(boundary));
    } else {
      LeaveOpen(whole[0]);
    }
  }
  return boundaries;
}

// Of one hole: thinned if it can be.
std::optional<RegionBoundary> LevelOutline::BoundaryOf(const std::vector<RegionLoop>& whole,
                                                       const std::vector<RegionLoop>& thinned) {
  for (RegionBoundary boundary : {SegmentsOf(thinned), SegmentsOf(whole)}) {
    if (IsBoundary(boundary)) return boundary;
  }
  RegionBoundary simple = SegmentsOf(LoopsBetween(region_.AtFirstPoints(region_.Simple(SegmentsOf(whole))), {}));
  return IsBoundary(simple) ? std::optional(std::move(simple)) : std::nullopt;
}

bool LevelOutline::IsBoundary(const RegionBoundary& segments) const {
  return region_.Triangulated(segments, {}).conflicts.empty();
}

void LevelOutline::LeaveOpen(const RegionLoop& outline) {
  Eigen::AlignedBox2d box;
  for (const int32_t v : outline) box.extend(region_.At(v));
  if (on_patch_.Meets(box) || on_cleared_.Meets(box)) open_.push_back(box.center());
}

RegionLoop LevelOutline::Thinned(const RegionLoop& loop, VertexThinning& thinning) const {
  RegionLoop thinned;
  for (size_t i = 0; i < loop.size(); ++i) {
    const int32_t v = loop[i], before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
    const bool is_end = IsOfLevel(before) != IsOfLevel(v) || IsOfLevel(after);
    if (IsOfLevel(v) || is_end || thinning.Take(region_.At(v), edge_)) thinned.push_back(v);
  }
  if (thinned.size() < 3) thinned.clear();
  return thinned;
}

std::vector<RegionLoop> LevelOutline::Loops() {
  // Of points at one place the first stands for all: that of the level, if it has one there.
  const int32_t level_first = region_.AddAll(level_outline_);
  const int32_t cleared_first = AddPlaced(cleared_outline_);
  patch_first_ = AddPlaced(patch_outline_);
  const int32_t seen_first = AddPlaced(seen_outline_);
  const int32_t finest_first = region_.AddAll(finest_outline_);
  footprint_ = region_.Simple(EdgesFrom(patch_outline_, patch_first_));
  if (footprint_.empty() && !HasCleared()) return {};
  const auto covered = region_.Simple(EdgesFrom(level_outline_, level_first));
  const auto fine = region_.Simple(EdgesFrom(finest_outline_, finest_first));
  const auto either = region_.Either(footprint_, fine);
  auto near = region_.Both(region_.Grown(footprint_, edge_), either);
  if (HasCleared()) {
    const auto cleared = region_.Simple(EdgesFrom(cleared_outline_, cleared_first));
    const auto seen = region_.Simple(EdgesFrom(seen_outline_, seen_first));
    near = region_.Either(near, region_.Both(cleared, region_.Either(footprint_, seen)));
  }
  // Rounding can leave two loops that run along each other: LoopsBetween drops what they pass to and fro.
  std::vector<RegionLoop> loops = LoopsBetween(region_.AtFirstPoints(region_.Without(near, covered)), {});
  for (RegionLoop& loop : loops) loop = AlongLevel(loop);
  std::erase_if(loops, [](const RegionLoop& loop) { return loop.size() < 3; });
  return LoopsBetween(SegmentsOf(loops), {});
}

// Adds the positions of an outline as points that keep their place in space; the number of the first.
int32_t LevelOutline::AddPlaced(const SurfaceOutline& outline) {
  const int32_t first = region_.AddAll(outline);
  placed_.emplace_back(first, &outline);
  return first;
}

// The loop without corners on a straight line between two vertices of the level: the level has no vertex there.
RegionLoop LevelOutline::AlongLevel(RegionLoop loop) const {
  const auto first = std::find_if(loop.begin(), loop.end(), [&](int32_t v) { return IsOfLevel(v); });
  if (first == loop.end()) return loop;
  std::rotate(loop.begin(), first, loop.end());
  RegionLoop along;
  for (auto from = loop.begin(); from != loop.end();) {
    const auto to = std::find_if(from + 1, loop.end(), [&](int32_t v) { return IsOfLevel(v); });
    const int32_t end = to == loop.end() ? loop.front() : *to;
    const bool is_edge = std::all_of(from + 1, to, [&](int32_t v) { return IsBetween(*from, end, v); });
    along.insert(along.end(), from, is_edge ? from + 1 : to);
    from = to;
  }
  return along;
}

bool LevelOutline::IsBetween(int32_t a, int32_t b, int32_t v) const {
  const auto at = [&](int32_t u) {
    const LatticePoint& p = region_.points()[u];
    return Point2(static_cast<double>(p.x), static_cast<double>(p.y));
  };
  return a != b && DistanceToSegment(at(v), at(a), at(b)) <= kRounding;
}

LatticeWindow LevelOutline::Window() const {
  Eigen::AlignedBox2d box;
  for (const SurfaceOutline* outline :
       {&level_outline_, &cleared_outline_, &patch_outline_, &seen_outline_, &finest_outline_}) {
    for (const Point3& p : outline->positions) box.extend(Point2(p.head<2>()));
  }
  for (const Point3& p : patch_.new_points) box.extend(Point2(p.head<2>()));
  for (const Point3& p : cleared_.points) box.extend(Point2(p.head<2>()));
  return {box.min(), box.max()};
}

double LevelOutline::EdgeBeside(const TriMesh& level) const {
  const std::vector<Triangle> beside = TrianglesNear(level, 0);
  if (!beside.empty()) return EdgeOf(level, beside);
  return HasCleared() ? EdgeOf(cleared_, cleared_.triangles) : EdgeOf(level, level.triangles);
}

// The triangles of a mesh whose boxes come within `reach` metres of the box of a triangle of the patch, or of one
// that was cleared.
std::vector<Triangle> LevelOutline::TrianglesNear(const TriMesh& mesh, double reach) const {
  const Point2 margin(reach, reach);
  std::vector<Triangle> near;
  for (const Triangle& t : mesh.triangles) {
    Eigen::AlignedBox2d box;
    for (const int32_t v : t) box.extend(Point2(mesh.points[v].head<2>()));
    box = {box.min() - margin, box.max() + margin};
    if (on_patch_.Meets(box) || on_cleared_.Meets(box)) near.push_back(t);
  }
  return near;
}

// Of the surface that matters: what is further away than a few edges cannot be part of the region.
std::vector<Triangle> LevelOutline::TrianglesNear(const TriMesh& mesh) const {
  return TrianglesNear(mesh, kReachInEdges * edge_);
}

// The outline of a part of a surface closes as well.
SurfaceOutline LevelOutline::OutlineNear(const TriMesh& mesh) const {
  const std::vector<Triangle> near = TrianglesNear(mesh);
  return SurfaceOutlineOf(near, [&](int32_t v) { return mesh.points[v]; });
}

}  // namespace tilemend
