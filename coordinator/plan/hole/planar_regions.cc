#include "coordinator/plan/hole/planar_regions.h"

#include <unordered_map>

#include "common/mesh/lattice.h"

namespace tilemend {
namespace {

// On the lattice of their own window.
std::vector<LatticePoint> OnLattice(const std::vector<int32_t>& vertices, const std::vector<Point3>& position) {
  Point2 lo = position[vertices[0]].head<2>(), hi = lo;
  for (const int32_t v : vertices) {
    lo = lo.cwiseMin(position[v].head<2>());
    hi = hi.cwiseMax(position[v].head<2>());
  }
  const LatticeWindow window(lo, hi);
  std::vector<LatticePoint> points;
  for (const int32_t v : vertices) points.push_back(window.Round(position[v].head<2>()));
  return points;
}

}  // namespace

PlanarRegions FindPlanarRegions(std::span<const RimSegment> segments, const std::vector<Point3>& position,
                                const std::function<bool()>& is_cancelled) {
  PlanarRegions regions;
  if (segments.empty()) return regions;
  std::unordered_map<int32_t, int32_t> number;
  std::vector<RegionSegment> local;
  const auto vertex = [&](int32_t v) {
    const auto [it, fresh] = number.try_emplace(v, static_cast<int32_t>(regions.vertices.size()));
    if (fresh) regions.vertices.push_back(v);
    return it->second;
  };
  for (const RimSegment& s : segments) {
    const int32_t from = vertex(s.from);
    local.push_back({from, vertex(s.to)});
  }
  regions.triangulation = TriangulateRegion(OnLattice(regions.vertices, position), local, is_cancelled);
  regions.area.assign(static_cast<size_t>(regions.triangulation.component_count), 0.0);
  for (size_t t = 0; t < regions.triangulation.triangles.size(); ++t) {
    const Triangle& tri = regions.triangulation.triangles[t];
    const Point3& a = position[regions.vertices[tri[0]]];
    const Eigen::Vector3d n = (position[regions.vertices[tri[1]]] - a).cross(position[regions.vertices[tri[2]]] - a);
    regions.area[regions.triangulation.component[t]] += n.z() / 2;
  }
  return regions;
}

bool Contains(const PlanarRegions& regions, int32_t component, const Point2& p, const std::vector<Point3>& position) {
  const auto turn = [](const Point2& a, const Point2& b, const Point2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  };
  for (size_t t = 0; t < regions.triangulation.triangles.size(); ++t) {
    if (regions.triangulation.component[t] != component) continue;
    const Triangle& tri = regions.triangulation.triangles[t];
    const auto at = [&](int k) { return Point2(position[regions.vertices[tri[k]]].head<2>()); };
    const Point2 a = at(0), b = at(1), c = at(2);
    if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return true;
  }
  return false;
}

Eigen::Vector3d VectorArea(std::span<const RimSegment> loop, const std::vector<Point3>& position) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Point3& origin = position[loop[0].from];
  for (const RimSegment& s : loop) sum += (position[s.from] - origin).cross(position[s.to] - origin);
  return sum / 2;
}

}  // namespace tilemend
