#include "common/mesh/triangulation/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/common/mesh/triangulation/delaunay_checks.h"

namespace tilemend::internal {
namespace {

using testing::CheckIsDelaunay;
using testing::CheckMesh;
using testing::CountReal;
using testing::MeshOf;
using testing::RandomPoints;
using Kind = Location::Kind;

TEST(DelaunayMeshTest, BeginsWithATriangleInAPlaneOfGhosts) {
  const DelaunayMesh mesh = MeshOf({{0, 0}, {10, 0}, {0, 10}});
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(CountReal(mesh), 1);
  CheckMesh(mesh);
}

TEST(DelaunayMeshTest, StaysDelaunayWithEveryPoint) {
  for (const int32_t side : {12, 100, 1 << 28}) {  // dense ones are full of cocircular and collinear points
    const DelaunayMesh mesh = MeshOf(RandomPoints(static_cast<uint32_t>(side), 100, side));
    CheckMesh(mesh);
    CheckIsDelaunay(mesh);
    // Euler: with ghosts a closed surface over the points and one at infinity.
    EXPECT_EQ(mesh.triangles.size(), 2u * (100 + 1) - 4);
  }
}

TEST(DelaunayMeshTest, FindsWhereAPointLies) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {12, 0}, {0, 12}});
  EXPECT_EQ(mesh.Locate({3, 3}, 0).kind, Kind::kInside);
  EXPECT_EQ(mesh.Locate({3, 3}, 0).triangle, 0);
  const Location edge = mesh.Locate({6, 6}, 0);
  EXPECT_EQ(edge.kind, Kind::kOnEdge);
  EXPECT_EQ(edge.k, 0);  // opposite to the first corner
  const Location vertex = mesh.Locate({12, 0}, 0);
  EXPECT_EQ(vertex.kind, Kind::kOnVertex);
  EXPECT_EQ(vertex.k, 1);
  const Location outside = mesh.Locate({20, 20}, 0);
  EXPECT_EQ(outside.kind, Kind::kInside);
  EXPECT_TRUE(mesh.triangles[outside.triangle].IsGhost());
}

TEST(DelaunayMeshTest, FindsEveryPointFromEveryTriangle) {
  DelaunayMesh mesh = MeshOf(RandomPoints(7, 60, 1000));
  for (int32_t start = 0; start < static_cast<int32_t>(mesh.triangles.size()); ++start) {
    if (mesh.triangles[start].IsGhost()) continue;
    for (int32_t v = 0; v < 60; ++v) {
      const Location where = mesh.Locate(mesh.points[v], start);
      ASSERT_EQ(where.kind, Kind::kOnVertex);
      ASSERT_EQ(mesh.triangles[where.triangle].corner[where.k], v);
    }
  }
}

TEST(DelaunayMeshTest, AWalkEndsAtAWallAndAtItsLimit) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {12, 0}, {0, 12}, {12, 12}});
  const Location far = mesh.Locate({11, 11}, mesh.Locate({1, 1}, 0).triangle);
  ASSERT_EQ(far.kind, Kind::kInside);
  const int32_t near = mesh.Locate({1, 1}, far.triangle).triangle;
  EXPECT_EQ(mesh.Locate({11, 11}, near, 1).kind, Kind::kBlocked);
  for (int k = 0; k < 3; ++k) {
    if (mesh.Twin(4 * near + k) >> 2 == far.triangle) mesh.triangles[near].twin[k] = ~5;
  }
  const Location blocked = mesh.Locate({11, 11}, near);
  EXPECT_EQ(blocked.kind, Kind::kBlocked);
  EXPECT_EQ(blocked.triangle, near);
  EXPECT_EQ(mesh.triangles[near].twin[blocked.k], ~5);
}

TEST(DelaunayMeshTest, TheRimOfACavityRunsAroundIt) {
  DelaunayMesh mesh = MeshOf(RandomPoints(3, 50, 1000));
  const Point32 p = {500, 501};
  const Location where = mesh.Locate(p, 0);
  ASSERT_NE(where.kind, Kind::kOnVertex);
  mesh.FindCavity(p, where);
  const auto rim = mesh.cavity_rim();
  for (size_t i = 0; i < rim.size(); ++i) EXPECT_EQ(mesh.Target(rim[i]), mesh.Origin(rim[(i + 1) % rim.size()]));
  EXPECT_EQ(rim.size(), mesh.cavity_triangles().size() + 2);
}

TEST(DelaunayMeshTest, FlippingTurnsAnEdgeAndKeepsItsConstraints) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  int32_t diagonal = -1;
  for (int32_t e = 0; e < static_cast<int32_t>(4 * mesh.triangles.size()); ++e) {
    if ((e & 3) == 3 || mesh.triangles[e >> 2].IsGhost()) continue;
    if (!mesh.triangles[mesh.Twin(e) >> 2].IsGhost()) {
      diagonal = e;
    } else if (mesh.Origin(e) == 0) {  // the side from (0, 0)
      for (const int32_t side : {e, mesh.Twin(e)}) mesh.triangles[side >> 2].flags |= 1u << (side & 3);
    }
  }
  ASSERT_GE(diagonal, 0);
  const int32_t p = mesh.Apex(diagonal), q = mesh.Apex(mesh.Twin(diagonal));
  mesh.Flip(diagonal);
  CheckMesh(mesh);
  int constrained = 0, turned = 0;
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
      turned += mesh.Origin(e) == p && mesh.Target(e) == q ? 1 : 0;
      if (!mesh.IsConstrained(e)) continue;
      ++constrained;
      EXPECT_EQ(std::min(mesh.Origin(e), mesh.Target(e)), 0);
    }
  }
  EXPECT_EQ(turned, 1);
  EXPECT_EQ(constrained, 2);
}

TEST(DelaunayMeshTest, KnowsAnIllegalEdge) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, -1}, {20, 0}, {10, 1}});
  int illegal = 0;
  const auto count = [&] {
    illegal = 0;
    for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
      for (int32_t e = 4 * t; e < 4 * t + 3; ++e) illegal += mesh.IsIllegal(e) ? 1 : 0;
    }
    return illegal;
  };
  EXPECT_EQ(count(), 0);
  for (int32_t e = 0; e < 4 * 6; ++e) {
    if ((e & 3) == 3 || mesh.triangles[e >> 2].IsGhost() || mesh.triangles[mesh.Twin(e) >> 2].IsGhost()) continue;
    mesh.Flip(e);
    break;
  }
  EXPECT_EQ(count(), 2);  // the long diagonal, from either side
}

TEST(RequireDeathTest, StopsTheProgramWithTheReason) {
  Require(true, "not shown");
  EXPECT_DEATH(Require(false, "two and two are four"), "precondition violated: two and two are four");
}

}  // namespace
}  // namespace tilemend::internal
