#include "common/assemble/level_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"
#include "common/mesh/winding/wound_region.h"

namespace tilemend {
namespace {

std::vector<DirectedEdge> Joined(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<DirectedEdge> Reversed(std::vector<DirectedEdge> edges) {
  for (DirectedEdge& e : edges) e = {e.to, e.from};
  return edges;
}

// The convex hull, counter-clockwise (Andrew 1979).
std::vector<LatticePoint> HullOf(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end());
  std::vector<LatticePoint> hull;
  for (int side = 0; side < 2; ++side) {
    const size_t least = hull.size() + 2;
    for (const LatticePoint& p : points) {
      while (hull.size() >= least && Orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace

SurfaceOutline SurfaceOutlineOf(std::span<const Triangle> triangles, const std::function<Point3(int32_t)>& point_of) {
  PositionIndex index;
  SurfaceOutline outline;
  std::unordered_map<uint64_t, int32_t> ways;  // how often an edge is passed this way
  std::vector<DirectedEdge> order;
  const auto number = [&](int32_t v) {
    const int32_t n = index.Insert(point_of(v));
    if (n == static_cast<int32_t>(outline.vertex.size())) outline.vertex.push_back(v);
    return n;
  };
  for (const Triangle& t : triangles) {
    const Triangle n{number(t[0]), number(t[1]), number(t[2])};
    if (n[0] == n[1] || n[1] == n[2] || n[0] == n[2]) continue;
    for (int k = 0; k < 3; ++k) {
      const DirectedEdge edge{n[k], n[(k + 1) % 3]};
      ++ways[EdgeKey(edge.from, edge.to)];
      order.push_back(edge);
    }
  }
  for (const DirectedEdge& edge : order) {
    int32_t& there = ways[EdgeKey(edge.from, edge.to)];
    const auto back = ways.find(EdgeKey(edge.to, edge.from));
    if (there <= 0 || (back != ways.end() && back->second >= there)) continue;
    outline.edges.push_back(edge);
    --there;
  }
  outline.positions = index.positions();
  return outline;
}

RegionBoundary SegmentsOf(const std::vector<RegionLoop>& loops) {
  RegionBoundary segments;
  for (const RegionLoop& loop : loops) {
    for (size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
  return segments;
}

std::vector<Triangle> FacingUp(const TriMesh& mesh, std::vector<Triangle> triangles) {
  const auto twice_area = [&](const Triangle& t) {
    const Point2 u = (mesh.points[t[1]] - mesh.points[t[0]]).head<2>();
    const Point2 v = (mesh.points[t[2]] - mesh.points[t[0]]).head<2>();
    return u.x() * v.y() - u.y() * v.x();
  };
  std::erase_if(triangles, [&](const Triangle& t) { return twice_area(t) == 0; });
  for (Triangle& t : triangles) {
    if (twice_area(t) < 0) std::swap(t[1], t[2]);
  }
  return triangles;
}

std::vector<DirectedEdge> EdgesFrom(const SurfaceOutline& outline, int32_t first) {
  std::vector<DirectedEdge> edges;
  for (const DirectedEdge& e : outline.edges) edges.push_back({first + e.from, first + e.to});
  return edges;
}

int32_t LevelRegion::Add(const Point2& p) {
  points_.push_back(window_.Round(p));
  return static_cast<int32_t>(points_.size()) - 1;
}

int32_t LevelRegion::AddAll(const SurfaceOutline& outline) {
  const auto first = static_cast<int32_t>(points_.size());
  for (const Point3& p : outline.positions) Add(p.head<2>());
  return first;
}

std::vector<DirectedEdge> LevelRegion::Simple(const std::vector<DirectedEdge>& edges) {
  const WoundRegion region = FindWoundRegion(points_, edges);
  for (const RegionCorner& corner : region.corners) points_.push_back(corner.place);
  return region.segments;
}

// Where the two wind around twice, the plane's reversed outline leaves one turn.
std::vector<DirectedEdge> LevelRegion::Both(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
  return Simple(Joined(Joined(std::move(a), b), Reversed(Everything())));
}

std::vector<DirectedEdge> LevelRegion::Either(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
  return Simple(Joined(std::move(a), b));
}

std::vector<DirectedEdge> LevelRegion::Without(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b) {
  return Simple(Joined(std::move(a), Reversed(b)));
}

std::vector<DirectedEdge> LevelRegion::Grown(const std::vector<DirectedEdge>& edges, double reach) {
  std::vector<DirectedEdge> all = edges;
  for (const DirectedEdge& e : edges) {
    AddHull(points_[e.from], points_[e.to], static_cast<int64_t>(reach / window_.step()), all);
  }
  return Simple(all);
}

std::vector<std::vector<int32_t>> LevelRegion::HolesOf(const std::vector<RegionLoop>& loops) const {
  std::vector<std::vector<int32_t>> holes;
  std::vector<int32_t> clockwise;
  std::vector<Eigen::AlignedBox2d> boxes(loops.size());
  for (int32_t i = 0; i < std::ssize(loops); ++i) {
    for (const int32_t v : loops[i]) boxes[i].extend(At(v));
    if (IsCounterClockwise(loops[i])) {
      holes.push_back({i});
    } else {
      clockwise.push_back(i);
    }
  }
  for (const int32_t i : clockwise) {
    std::vector<int32_t>* around = nullptr;
    for (std::vector<int32_t>& hole : holes) {
      const Eigen::AlignedBox2d& box = boxes[hole[0]];
      if (around != nullptr && box.volume() >= boxes[around->front()].volume()) continue;
      if (box.contains(boxes[i]) && HasInside(loops[hole[0]], loops[i])) around = &hole;
    }
    if (around != nullptr) around->push_back(i);
  }
  return holes;
}

// At its lowest point a simple loop turns as it does as a whole.
bool LevelRegion::IsCounterClockwise(const RegionLoop& loop) const {
  const auto lowest = std::ranges::min_element(loop, {}, [&](int32_t v) { return points_[v]; });
  const auto at = static_cast<size_t>(lowest - loop.begin());
  const int32_t before = loop[(at + loop.size() - 1) % loop.size()], after = loop[(at + 1) % loop.size()];
  return Orientation(points_[before], points_[*lowest], points_[after]) > 0;
}

// Looks at the middle of a side of `other`: corners of both may be the same.
bool LevelRegion::HasInside(const RegionLoop& loop, const RegionLoop& other) const {
  const LatticePoint from = points_[other[0]], to = points_[other[1]], p{from.x + to.x, from.y + to.y};
  bool inside = false;
  for (size_t i = 0; i < loop.size(); ++i) {
    const LatticePoint& u = points_[loop[i]];
    const LatticePoint& v = points_[loop[(i + 1) % loop.size()]];
    const LatticePoint a{2 * u.x, 2 * u.y}, b{2 * v.x, 2 * v.y};
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (Orientation(a, b, p) == (b.y > a.y ? 1 : -1)) inside = !inside;
  }
  return inside;
}

RegionTriangulation LevelRegion::Triangulated(const RegionBoundary& segments, const std::vector<int32_t>& free) const {
  std::vector<int32_t> used = free;
  for (const DirectedEdge& s : segments) used.push_back(s.from);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto place = [&](int32_t v) {
    return static_cast<int32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  std::vector<LatticePoint> points;
  for (const int32_t v : used) points.push_back(points_[v]);
  std::vector<RegionSegment> between;
  for (const DirectedEdge& s : segments) between.push_back({place(s.from), place(s.to)});
  RegionTriangulation mesh = TriangulateRegion(points, between);
  for (Triangle& t : mesh.triangles) t = {used[t[0]], used[t[1]], used[t[2]]};
  return mesh;
}

std::vector<DirectedEdge> LevelRegion::AtFirstPoints(std::vector<DirectedEdge> edges) const {
  std::map<LatticePoint, int32_t> first;
  for (int32_t v = 0; v < std::ssize(points_); ++v) first.emplace(points_[v], v);
  for (DirectedEdge& e : edges) e = {first.at(points_[e.from]), first.at(points_[e.to])};
  return edges;
}

// Adds the hull of the squares about two points.
void LevelRegion::AddHull(LatticePoint a, LatticePoint b, int64_t reach, std::vector<DirectedEdge>& edges) {
  std::vector<LatticePoint> corners;
  for (const LatticePoint& p : {a, b}) {
    for (const int64_t x : {-reach, reach}) {
      for (const int64_t y : {-reach, reach}) corners.push_back({p.x + x, p.y + y});
    }
  }
  const std::vector<LatticePoint> hull = HullOf(std::move(corners));
  const auto first = static_cast<int32_t>(points_.size()), n = static_cast<int32_t>(hull.size());
  points_.insert(points_.end(), hull.begin(), hull.end());
  for (int32_t i = 0; i < n; ++i) edges.push_back({first + i, first + (i + 1) % n});
}

std::vector<DirectedEdge> LevelRegion::Everything() {
  constexpr int64_t kFar = (int64_t{1} << 29) - 1;
  const auto first = static_cast<int32_t>(points_.size());
  points_.insert(points_.end(), {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar}, {-kFar, kFar}});
  return {{first, first + 1}, {first + 1, first + 2}, {first + 2, first + 3}, {first + 3, first}};
}

}  // namespace tilemend
