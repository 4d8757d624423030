#include "worker/fill/region/mesh_order.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/mesh/triangulation/insertion_order.h"

namespace tilemend::internal {
namespace {

// The place of each element of a permutation.
std::vector<int32_t> Inverse(const std::vector<int32_t>& order) {
  std::vector<int32_t> place(order.size());
  for (size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int32_t>(i);
  return place;
}

template <typename T>
std::vector<T> Permuted(const std::vector<T>& values, const std::vector<int32_t>& order) {
  std::vector<T> result;
  result.reserve(order.size());
  for (const int32_t i : order) result.push_back(values[i]);
  return result;
}

// The indices of the triangles, by their lowest corner.
std::vector<int32_t> OrderByLowestCorner(const std::vector<MeshTriangle>& triangles, size_t point_count) {
  const auto lowest = [](const MeshTriangle& t) { return std::min({t.corner[0], t.corner[1], t.corner[2]}); };
  std::vector<int32_t> next(point_count + 1, 0), order(triangles.size());
  for (const MeshTriangle& t : triangles) ++next[lowest(t) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (size_t t = 0; t < triangles.size(); ++t) order[next[lowest(triangles[t])]++] = static_cast<int32_t>(t);
  return order;
}

}  // namespace

void SortMesh(DelaunayMesh& mesh, size_t first, std::vector<double>& size) {
  std::vector<int32_t> points(mesh.points.size());
  std::iota(points.begin(), points.end(), 0);
  std::vector<int32_t> movable(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  SortAlongCurve(mesh.points, movable);
  std::copy(movable.begin(), movable.end(), points.begin() + static_cast<std::ptrdiff_t>(first));
  mesh.points = Permuted(mesh.points, points);
  size = Permuted(size, points);

  const std::vector<int32_t> point_at = Inverse(points);
  for (MeshTriangle& t : mesh.triangles) {
    for (int32_t& v : t.corner) v = point_at[v];
  }
  const std::vector<int32_t> triangles = OrderByLowestCorner(mesh.triangles, mesh.points.size());
  const std::vector<int32_t> triangle_at = Inverse(triangles);
  mesh.triangles = Permuted(mesh.triangles, triangles);
  for (MeshTriangle& t : mesh.triangles) {
    for (int32_t& twin : t.twin) {
      if (twin >= 0) twin = 4 * triangle_at[twin >> 2] + (twin & 3);
    }
  }
}

}  // namespace tilemend::internal
