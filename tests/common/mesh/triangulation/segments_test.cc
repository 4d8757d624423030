#include "common/mesh/triangulation/segments.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/common/mesh/triangulation/delaunay_checks.h"

namespace tilemend::internal {
namespace {

using testing::CheckIsDelaunay;
using testing::CheckMesh;
using testing::MeshOf;
using testing::RandomPoints;

// The constrained half-edges from a to b.
int CountConstrained(const DelaunayMesh& mesh, int32_t a, int32_t b) {
  int count = 0;
  for (int32_t t = 0; t < static_cast<int32_t>(mesh.triangles.size()); ++t) {
    for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
      count += mesh.IsConstrained(e) && mesh.Origin(e) == a && mesh.Target(e) == b ? 1 : 0;
    }
  }
  return count;
}

TEST(SegmentInserterTest, MarksAnEdgeThatIsThere) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, 0}, {0, 10}});
  EXPECT_FALSE(SegmentInserter(mesh).Insert(0, 1).has_value());
  EXPECT_EQ(CountConstrained(mesh, 0, 1), 1);
  EXPECT_EQ(CountConstrained(mesh, 1, 0), 1);
  CheckMesh(mesh);
}

TEST(SegmentInserterTest, TurnsTheDiagonalOfAFlatQuadrilateral) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, -1}, {20, 0}, {10, 1}});
  EXPECT_FALSE(SegmentInserter(mesh).Insert(0, 2).has_value());
  EXPECT_EQ(CountConstrained(mesh, 0, 2), 1);
  CheckMesh(mesh);
}

TEST(SegmentInserterTest, CutsThroughManyTrianglesAndStaysDelaunayBeside) {
  int inserted = 0;
  for (uint32_t seed = 0; seed < 20; ++seed) {
    std::vector<Point32> points = RandomPoints(seed, 120, 1000);
    points.push_back({-3, 501});
    points.push_back({1003, 497});
    DelaunayMesh mesh = MeshOf(points);
    const auto obstacle = SegmentInserter(mesh).Insert(120, 121);
    CheckMesh(mesh);
    CheckIsDelaunay(mesh);
    if (obstacle.has_value()) {
      EXPECT_TRUE(obstacle->is_point);  // by chance, in few of the meshes
    } else {
      EXPECT_EQ(CountConstrained(mesh, 120, 121), 1);
      ++inserted;
    }
  }
  EXPECT_GE(inserted, 15);
}

TEST(SegmentInserterTest, NamesThePointOnItsWayAndChangesNothing) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, 0}, {5, 5}, {20, 0}, {10, 7}, {10, -7}});
  const std::vector<MeshTriangle> before = mesh.triangles;
  const auto obstacle = SegmentInserter(mesh).Insert(0, 3);
  ASSERT_TRUE(obstacle.has_value());
  EXPECT_TRUE(obstacle->is_point);
  EXPECT_EQ(obstacle->a, 1);
  for (size_t t = 0; t < before.size(); ++t) {
    EXPECT_EQ(mesh.triangles[t].corner, before[t].corner);
    EXPECT_EQ(mesh.triangles[t].flags, before[t].flags);
  }
}

TEST(SegmentInserterTest, NamesAPointBehindTheFirstEdgeThatItCrosses) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {8, -10}, {8, 10}, {16, 0}, {32, 0}});
  const auto obstacle = SegmentInserter(mesh).Insert(0, 4);
  ASSERT_TRUE(obstacle.has_value());
  EXPECT_TRUE(obstacle->is_point);
  EXPECT_EQ(obstacle->a, 3);
}

TEST(SegmentInserterTest, NamesTheSegmentThatItWouldCross) {
  DelaunayMesh mesh = MeshOf({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  SegmentInserter inserter(mesh);
  EXPECT_FALSE(inserter.Insert(0, 2).has_value());
  const auto obstacle = inserter.Insert(1, 3);
  ASSERT_TRUE(obstacle.has_value());
  EXPECT_FALSE(obstacle->is_point);
  EXPECT_EQ(std::min(obstacle->a, obstacle->b), 0);
  EXPECT_EQ(std::max(obstacle->a, obstacle->b), 2);
  EXPECT_EQ(CountConstrained(mesh, 1, 3), 0);
  CheckMesh(mesh);
}

TEST(SegmentInserterTest, KeepsTheSegmentsBesideIt) {
  // A fan of segments from one corner through a cloud, inserted one after the other.
  std::vector<Point32> points = {{0, 0}, {4000, 1}, {-1, 4000}};
  for (const Point32& p : RandomPoints(5, 200, 1000)) points.push_back({3 * p.x + 7, 3 * p.y + 11});
  for (int i = 1; i < 10; ++i) points.push_back({4000 - 401 * i, 401 * i + 3});
  DelaunayMesh mesh = MeshOf(points);
  SegmentInserter inserter(mesh);
  std::vector<int32_t> reached;
  for (int32_t v = static_cast<int32_t>(points.size()) - 9; v < static_cast<int32_t>(points.size()); ++v) {
    if (!inserter.Insert(0, v).has_value()) reached.push_back(v);
    CheckMesh(mesh);
    CheckIsDelaunay(mesh);
    for (const int32_t r : reached) EXPECT_EQ(CountConstrained(mesh, 0, r), 1);
  }
  EXPECT_GE(reached.size(), 7u);
}

}  // namespace
}  // namespace tilemend::internal
