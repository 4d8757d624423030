#include "worker/check/fill_pieces.h"

#include <algorithm>
#include <map>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/position_index.h"

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

TileFills FillsOf(const TriMesh& mesh, const std::vector<bool>& added) {
  PositionIndex index;
  std::vector<std::pair<uint64_t, int32_t>> sides;  // edges of positions; by the number of their added triangle
  std::vector<int32_t> numbers;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!added[t]) continue;
    Triangle welded;
    for (int k = 0; k < 3; ++k) welded[k] = index.Insert(mesh.points[mesh.triangles[t][k]]);
    for (int k = 0; k < 3; ++k) {
      const auto [lo, hi] = std::minmax(welded[k], welded[(k + 1) % 3]);
      if (lo != hi) sides.emplace_back(EdgeKey(lo, hi), static_cast<int32_t>(numbers.size()));
    }
    numbers.push_back(static_cast<int32_t>(t));
  }
  std::ranges::sort(sides);
  DisjointSets sets(static_cast<int32_t>(numbers.size()));
  std::vector<std::pair<uint64_t, int32_t>> outer;
  for (size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next].first == sides[i].first) ++next;
    if (next - i == 2) sets.Join(sides[i].second, sides[i + 1].second);
    if (next - i == 1) outer.push_back(sides[i]);
  }
  const std::vector<int32_t> group = sets.Groups();
  TileFills fills{std::vector<int32_t>(mesh.triangles.size(), -1), {}};
  for (size_t k = 0; k < numbers.size(); ++k) fills.of_triangle[numbers[k]] = group[k];
  fills.rims.resize(group.empty() ? 0 : static_cast<size_t>(std::ranges::max(group)) + 1);
  for (const auto& [edge, k] : outer) {
    const Point3 &a = index.positions()[edge >> 32], &b = index.positions()[edge & 0xffffffffU];
    fills.rims[group[k]].emplace_back(a, b);
  }
  return fills;
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
