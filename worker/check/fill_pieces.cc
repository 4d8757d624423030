#include "worker/check/fill_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_key.h"

namespace tilemend {

std::vector<std::vector<Triangle>> PiecesByEdges(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<uint64_t, int32_t>> sides;
  for (int32_t t = 0; t < std::ssize(triangles); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [lo, hi] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      sides.emplace_back(EdgeKey(lo, hi), t);
    }
  }
  std::sort(sides.begin(), sides.end());
  DisjointSets sets(static_cast<int32_t>(triangles.size()));
  for (size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].first == sides[i - 1].first) sets.Join(sides[i].second, sides[i - 1].second);
  }
  std::map<int32_t, std::vector<Triangle>> by_triangle;
  for (int32_t t = 0; t < std::ssize(triangles); ++t) by_triangle[sets.LowestOf(t)].push_back(triangles[t]);
  std::vector<std::vector<Triangle>> pieces;
  for (auto& [lowest, piece] : by_triangle) pieces.push_back(std::move(piece));
  return pieces;
}

AddedArea AddedAreaWithin(const Point2& lo, const Point2& hi, const TriMesh& mesh, const std::vector<bool>& added) {
  AddedArea area;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!added[t]) continue;
    const auto [a, b, c] = mesh.triangles[t];
    const Point3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const Point2 middle = ((p + q + r) / 3).head<2>();
    if ((middle.array() < lo.array()).any() || (middle.array() >= hi.array()).any()) continue;
    const Point3 normal = (q - p).cross(r - p);
    area.from_above += normal.z() / 2;
    area.in_space += normal.norm() / 2;
  }
  return area;
}

}  // namespace tilemend
