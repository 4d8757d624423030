#include "coordinator/plan/hole/planar_regions.h"

#include <gtest/gtest.h>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

const std::vector<Point3> kTwoSquares = {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5},  //
                                         {5, 0, 0}, {8, 0, 0}, {8, 3, 9}, {5, 3, 9}};

std::vector<RimSegment> LoopOver(const std::vector<int32_t>& vertices) {
  std::vector<RimSegment> loop;
  for (size_t i = 0; i < vertices.size(); ++i) loop.push_back({vertices[i], vertices[(i + 1) % vertices.size()]});
  return loop;
}

std::vector<RimSegment> operator+(std::vector<RimSegment> a, const std::vector<RimSegment>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(FindPlanarRegionsTest, MeasuresEachRegionFromAbove) {
  const PlanarRegions regions = FindPlanarRegions(LoopOver({0, 1, 2, 3}) + LoopOver({4, 5, 6, 7}), kTwoSquares);
  ASSERT_EQ(regions.area.size(), 2U);
  EXPECT_DOUBLE_EQ(regions.area[0], 4);
  EXPECT_DOUBLE_EQ(regions.area[1], 9);
}

TEST(FindPlanarRegionsTest, LeavesIslandsOut) {
  const std::vector<Point3> position = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},  //
                                        {3, 3, 0}, {3, 5, 0}, {5, 5, 0}, {5, 3, 0}};
  const PlanarRegions regions = FindPlanarRegions(LoopOver({0, 1, 2, 3}) + LoopOver({4, 5, 6, 7}), position);
  ASSERT_EQ(regions.area.size(), 1U);
  EXPECT_DOUBLE_EQ(regions.area[0], 81 - 4);
  EXPECT_FALSE(Contains(regions, 0, {4, 4}, position));
  EXPECT_TRUE(Contains(regions, 0, {1, 1}, position));
}

TEST(FindPlanarRegionsTest, SaysWhereSegmentsBoundNone) {
  EXPECT_FALSE(FindPlanarRegions(LoopOver({0, 2, 1, 3}), kTwoSquares).triangulation.conflicts.empty());
  EXPECT_TRUE(FindPlanarRegions({}, kTwoSquares).area.empty());
}

TEST(ContainsTest, TellsTheRegionsApart) {
  const PlanarRegions regions = FindPlanarRegions(LoopOver({0, 1, 2, 3}) + LoopOver({4, 5, 6, 7}), kTwoSquares);
  EXPECT_TRUE(Contains(regions, 0, {1, 1.5}, kTwoSquares));
  EXPECT_FALSE(Contains(regions, 1, {1, 1.5}, kTwoSquares));
  EXPECT_TRUE(Contains(regions, 1, {6, 1}, kTwoSquares));
  EXPECT_FALSE(Contains(regions, 0, {3, 1}, kTwoSquares));
  EXPECT_FALSE(Contains(regions, 1, {3, 1}, kTwoSquares));
}

TEST(VectorAreaTest, PointsAlongTheNormalWithTheAreasLength) {
  const Eigen::Vector3d slope = VectorArea(LoopOver({4, 5, 6, 7}), kTwoSquares);
  EXPECT_TRUE(slope.isApprox(Eigen::Vector3d(0, -27, 9))) << slope.transpose();
  EXPECT_TRUE(VectorArea(LoopOver({7, 6, 5, 4}), kTwoSquares).isApprox(-slope));
}

TEST(VectorAreaTest, DoesNotDependOnTheStartNorOnThePlace) {
  std::vector<Point3> far = kTwoSquares;
  for (Point3& p : far) p += Point3(4000, -2000, 100);
  const Eigen::Vector3d area = VectorArea(LoopOver({4, 5, 6, 7}), kTwoSquares);
  EXPECT_TRUE(VectorArea(LoopOver({6, 7, 4, 5}), kTwoSquares).isApprox(area));
  EXPECT_TRUE(VectorArea(LoopOver({4, 5, 6, 7}), far).isApprox(area));
}

}  // namespace
}  // namespace tilemend
