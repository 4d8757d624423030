// Small random meshes with faces removed, duplicated, turned and pinched: nothing crashes, and nothing is made worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/triangle_copies.h"
#include "tests/support/filled_mesh.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/survey/orient_faces.h"

namespace tilemend {
namespace {

using EdgeCounts = std::map<std::pair<int32_t, int32_t>, int>;

TriMesh SoupOf(uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  TriMesh mesh = seed % 3 == 0   ? BoxMesh(3)
                 : seed % 3 == 1 ? SphereBelt(0, 150, 10, 6)
                                 : SquaresMesh(0, 6, 0, 6, [](int32_t, int32_t) { return true; });
  mesh = Shaken(mesh, 0.05 * static_cast<double>(below(4)), seed);
  for (size_t k = below(12); k > 0; --k) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<ptrdiff_t>(below(mesh.triangles.size())));
  }
  for (size_t k = below(3); k > 0; --k) {
    const Triangle copy = mesh.triangles[below(mesh.triangles.size())];
    mesh.triangles.push_back(copy);
  }
  for (size_t k = below(3); k > 0; --k) {
    Triangle& t = mesh.triangles[below(mesh.triangles.size())];
    std::swap(t[0], t[1]);
  }
  for (size_t k = below(3); k > 0; --k) {
    const size_t from = below(mesh.points.size());
    mesh.points[below(mesh.points.size())] = mesh.points[from];
  }
  return mesh;
}

// A mesh welded, with each triangle once: one that is listed twice is one face.
TriMesh WeldedOnce(TriMesh mesh) {
  if (auto once = WithoutCopies(mesh)) mesh.triangles = *std::move(once);
  return Welded(mesh);
}

// By edge without direction: the triangles with three corners.
EdgeCounts EdgesOf(const TriMesh& mesh, size_t first, size_t last) {
  EdgeCounts counts;
  for (size_t t = first; t < last; ++t) {
    const Triangle& tri = mesh.triangles[t];
    if (tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0]) continue;
    for (int k = 0; k < 3; ++k) ++counts[std::minmax(tri[k], tri[(k + 1) % 3])];
  }
  return counts;
}

// How many triangles have each edge in its direction.
EdgeCounts DirectedEdgesOf(const TriMesh& mesh, size_t first, size_t last) {
  EdgeCounts counts;
  for (size_t t = first; t < last; ++t) {
    const Triangle& tri = mesh.triangles[t];
    if (tri[0] == tri[1] || tri[1] == tri[2] || tri[2] == tri[0]) continue;
    for (int k = 0; k < 3; ++k) ++counts[{tri[k], tri[(k + 1) % 3]}];
  }
  return counts;
}

SpaceTriangle At(const TriMesh& mesh, size_t t) {
  const Triangle& tri = mesh.triangles[t];
  return {mesh.points[tri[0]], mesh.points[tri[1]], mesh.points[tri[2]]};
}

// Whether a triangle passes through an edge of one of the rims: no patch that closes on it could pass the triangle by.
// `rims`: edges that one new triangle has.
bool PassesThroughRim(const TriMesh& mesh, const SpaceTriangle& triangle, const EdgeCounts& rims) {
  return std::ranges::any_of(rims, [&](const auto& rim) {
    if (rim.second != 1) return false;
    const Point3 &a = mesh.points[rim.first.first], &b = mesh.points[rim.first.second];
    const auto has = [&](const Point3& p) { return std::ranges::find(triangle, p) != triangle.end(); };
    return !has(a) && !has(b) && SegmentCrosses(a, b, triangle);
  });
}

// Pairs of a new triangle and another one that cross and need not: where the surface passes through one rim, and has
// another one there, the patches of both cross as well.
int CrossingsOf(const FilledMesh& filled) {
  const TriMesh& mesh = filled.mesh;
  const EdgeCounts rims = EdgesOf(mesh, filled.originals, mesh.triangles.size());
  int crossings = 0;
  for (size_t a = filled.originals; a < mesh.triangles.size(); ++a) {
    const SpaceTriangle triangle = At(mesh, a);
    const Eigen::AlignedBox3d box = BoxOf(triangle);
    for (size_t b = 0; b < a; ++b) {
      const SpaceTriangle other = At(mesh, b);
      if (!box.intersects(BoxOf(other)) || !HasArea(other) || !TrianglesCross(triangle, other)) continue;
      if (!PassesThroughRim(mesh, other, rims) && !PassesThroughRim(mesh, triangle, rims)) ++crossings;
    }
  }
  return crossings;
}

TEST(SoupTest, IsNeverMadeWorse) {
  constexpr uint32_t kMeshes = 10000;
  int64_t holes = 0, filled_holes = 0;
  for (uint32_t seed = 0; seed < kMeshes; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const TriMesh mesh = SoupOf(seed);
    FilledMesh filled = Fill(mesh);
    filled.mesh = Welded(filled.mesh);  // where there was no hole it is as it was
    holes += std::ssize(filled.plan.holes);
    filled_holes += std::ssize(filled.plan.holes) - std::ssize(filled.failures);
    // Originals kept: the welded mesh begins with them.
    ASSERT_EQ(filled.originals, mesh.triangles.size());
    const TriMesh welded = Welded(mesh);
    ASSERT_TRUE(std::equal(welded.triangles.begin(), welded.triangles.end(), filled.mesh.triangles.begin()));
    ASSERT_TRUE(std::equal(welded.points.begin(), welded.points.end(), filled.mesh.points.begin()));
    TriMesh oriented = WeldedOnce(mesh);
    const EdgeCounts before = EdgesOf(oriented, 0, oriented.triangles.size());
    for (const auto& [edge, count] : EdgesOf(filled.mesh, filled.originals, filled.mesh.triangles.size())) {
      const auto old = before.find(edge);
      ASSERT_LE(count + (old == before.end() ? 0 : old->second), 2) << "an edge with three triangles";
    }
    OrientFaces(PointRows(oriented.points), oriented.triangles);  // turned faces count as if they were turned back
    const EdgeCounts along = DirectedEdgesOf(oriented, 0, oriented.triangles.size());
    for (const auto& [edge, count] : DirectedEdgesOf(filled.mesh, filled.originals, filled.mesh.triangles.size())) {
      ASSERT_EQ(count, 1) << "an edge of two new triangles that face opposite ways";
      ASSERT_FALSE(along.contains(edge)) << "a new triangle that faces another way than the surface beside it";
    }
    ASSERT_EQ(CrossingsOf(filled), 0);
    for (size_t t = filled.originals; t < filled.mesh.triangles.size(); ++t) {
      const Triangle& tri = filled.mesh.triangles[t];
      const auto& p = filled.mesh.points;
      ASSERT_GT((p[tri[1]] - p[tri[0]]).cross(p[tri[2]] - p[tri[0]]).norm(), 0) << "a triangle without area";
    }
  }
  EXPECT_GT(filled_holes, holes * 8 / 10);
}

}  // namespace
}  // namespace tilemend
