#include "coordinator/plan/overlap/wall_feet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::SizeIs;

PlanVertex At(double x, double y, int32_t index, int32_t follows) {
  PlanVertex v;
  v.position = Point3(x, y, 0);
  v.index = index;
  v.follows = follows;
  v.size = 2;
  v.lines = follows >= 0 ? 2 : 0;
  return v;
}

// A gap along an outline at y = 10 from one rim vertex over two new ones to another.
Plan PlanOfGap(bool on_object) {
  Plan plan;
  plan.lattice_step = 1.0 / 1024;
  plan.vertices = {At(0, 10, 0, -1), At(2, 10, -1, 5), At(4, 10, -1, 6), At(6, 10, 1, -1), At(3, 0, 2, -1)};
  plan.vertices[0].on_object = on_object;
  PlannedHole hole;
  hole.own_regions = {{{0, 1, true}, {1, 2, true}, {2, 3, true}, {3, 4, false}, {4, 0, false}}};
  plan.holes = {hole};
  return plan;
}

TEST(WallFeetTest, StandCloseToTheWallOnTheOutline) {
  Plan plan = PlanOfGap(true);
  LayWallFeet(plan);
  ASSERT_THAT(plan.vertices, SizeIs(6));
  const PlanVertex& foot = plan.vertices[5];
  EXPECT_NEAR(foot.position.x(), 0.02, plan.lattice_step);
  EXPECT_EQ(foot.position.y(), 10);
  EXPECT_EQ(foot.follows, 5) << "as its neighbour";
  const std::vector<RimSegment>& region = plan.holes[0].own_regions[0];
  ASSERT_THAT(region, SizeIs(6));
  EXPECT_EQ(region[0].from, 0);
  EXPECT_EQ(region[0].to, 5);
  EXPECT_EQ(region[1].from, 5);
  EXPECT_EQ(region[1].to, 1);
  EXPECT_TRUE(region[0].seam && region[1].seam);
}

TEST(WallFeetTest, HaveTheHeightWhereTheWallIs) {
  Plan plan = PlanOfGap(true);
  plan.vertices[0].follows = 7;
  LayWallFeet(plan);
  EXPECT_EQ(plan.vertices.back().follows, 7);
}

// The neighbour's surface ends at the next vertex, high above the ground where the wall is.
TEST(WallFeetTest, OfTheTilesOwnObjectsAreNotOnTheNeighbour) {
  Plan plan = PlanOfGap(true);
  plan.vertices.push_back(At(2, 10.1, 7, -1));
  plan.vertices[0].follows = 4;
  plan.vertices[1].on_neighbour = true;
  LayWallFeet(plan);
  ASSERT_THAT(plan.vertices, SizeIs(7));
  EXPECT_EQ(plan.vertices[6].follows, 4);
  EXPECT_FALSE(plan.vertices[6].on_neighbour);
}

// A foot rounded to the lattice would lie on the next vertex.
TEST(WallFeetTest, AreNoneWhereTheNextVertexIsAHairOff) {
  for (const double x : {1.9998, 2.0, 2 - 3 * 0x1p-10}) {
    Plan plan = PlanOfGap(true);
    plan.vertices[0].position.x() = x;
    LayWallFeet(plan);
    EXPECT_THAT(plan.vertices, SizeIs(5)) << x;
  }
  Plan plan = PlanOfGap(true);
  plan.vertices[0].position.x() = 2 - 4 * 0x1p-10;
  LayWallFeet(plan);
  ASSERT_THAT(plan.vertices, SizeIs(6));
  EXPECT_EQ(plan.vertices[5].position.x(), 2 - 3 * 0x1p-10);
}

// The edge of an area goes on from the wall in any direction.
TEST(WallFeetTest, AreNoneOffTheOutline) {
  Plan plan = PlanOfGap(true);
  plan.vertices[0].position.y() = 10.01;
  LayWallFeet(plan);
  EXPECT_THAT(plan.vertices, SizeIs(5));
}

// The neighbour's surface goes over the outline there, up on the object.
TEST(WallFeetTest, StandWhereTheNeighboursObjectEnds) {
  Plan plan = PlanOfGap(false);
  plan.vertices.push_back(At(2, 10.1, 7, -1));
  plan.vertices[5].on_object = true;
  plan.vertices[1].on_neighbour = true;
  LayWallFeet(plan);
  EXPECT_TRUE(plan.vertices[1].on_object) << "as what it follows";
  ASSERT_THAT(plan.vertices, SizeIs(7));
  EXPECT_NEAR(plan.vertices[6].position.x(), 2.02, plan.lattice_step);
  const std::vector<RimSegment>& region = plan.holes[0].own_regions[0];
  ASSERT_THAT(region, SizeIs(6));
  EXPECT_EQ(region[0].to, 1) << "no foot before it";
  EXPECT_EQ(region[1].to, 6);
  EXPECT_EQ(region[2].from, 6);
}

TEST(WallFeetTest, AreOfObjectsOnly) {
  Plan plan = PlanOfGap(false);
  LayWallFeet(plan);
  EXPECT_THAT(plan.vertices, SizeIs(5));
  EXPECT_THAT(plan.holes[0].own_regions[0], SizeIs(5));
}

}  // namespace
}  // namespace tilemend
