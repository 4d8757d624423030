// Builds Delaunay meshes with ghosts, and checks them by means that share no code with the triangulator.
#ifndef TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_DELAUNAY_CHECKS_H_
#define TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_DELAUNAY_CHECKS_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "common/mesh/lattice.h"
#include "common/mesh/triangulation/delaunay.h"

namespace tilemend::testing {

// Inserts all points in their order; the first three turn left, none coincide.
inline internal::DelaunayMesh MeshOf(const std::vector<internal::Point32>& points) {
  internal::DelaunayMesh mesh;
  mesh.points = points;
  mesh.Start(0, 1, 2);
  int32_t v = 3;
  for (const internal::Point32& p : std::span(points).subspan(3)) {
    int32_t start = 0;
    while (mesh.triangles[start].IsGhost()) ++start;
    const internal::Location where = mesh.Locate(p, start);
    mesh.FindCavity(p, where);
    mesh.FillCavity(v++);
  }
  return mesh;
}

// Distinct points of a square; the first three turn left.
inline std::vector<internal::Point32> RandomPoints(uint32_t seed, int count, int32_t side) {
  std::mt19937 random(seed);
  std::vector<internal::Point32> points = {{0, 0}, {1, 0}, {0, 1}};
  while (points.size() < static_cast<size_t>(count)) {
    const internal::Point32 p = {static_cast<int32_t>(random() % static_cast<uint32_t>(side)),
                                 static_cast<int32_t>(random() % static_cast<uint32_t>(side))};
    if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
  }
  return points;
}

// Twins point at each other along the same edge, real triangles turn left, and no constrained edge is so on one side
// alone.
inline void CheckMesh(const internal::DelaunayMesh& mesh) {
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    const internal::MeshTriangle& triangle = mesh.triangles[t];
    if (!triangle.IsGhost()) {
      const auto at = [&](int k) { return internal::Widen(mesh.points[triangle.corner[k]]); };
      ASSERT_GT(Orientation(at(0), at(1), at(2)), 0) << t;
    }
    for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
      const int32_t twin = mesh.Twin(e);
      ASSERT_GE(twin, 0);
      ASSERT_EQ(mesh.Twin(twin), e);
      ASSERT_EQ(mesh.Origin(twin), mesh.Target(e));
      ASSERT_EQ(mesh.Target(twin), mesh.Origin(e));
      ASSERT_EQ(mesh.IsConstrained(twin), mesh.IsConstrained(e));
    }
  }
}

// No far corner of an edge that is not constrained lies inside a triangle's circle.
inline void CheckIsDelaunay(const internal::DelaunayMesh& mesh) {
  const auto at = [&](int32_t v) { return internal::Widen(mesh.points[v]); };
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    if (mesh.triangles[t].IsGhost()) continue;
    for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
      const int32_t apex = mesh.Apex(mesh.Twin(e));
      if (apex < 0 || mesh.IsConstrained(e)) continue;
      const auto& [a, b, c] = mesh.triangles[t].corner;
      ASSERT_LE(InCircle(at(a), at(b), at(c), at(apex)), 0) << t;
    }
  }
}

inline int CountReal(const internal::DelaunayMesh& mesh) {
  int count = 0;
  for (const internal::MeshTriangle& t : mesh.triangles) count += t.IsGhost() ? 0 : 1;
  return count;
}

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_DELAUNAY_CHECKS_H_
