#include "coordinator/plan/hole/touching_holes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tilemend {
namespace {

using Pairs = std::vector<std::pair<int32_t, int32_t>>;

Plan HolesWith(const std::vector<std::vector<RimSegment>>& segments) {
  Plan plan;
  for (const auto& of_hole : segments) {
    plan.holes.emplace_back();
    plan.holes.back().segments = of_hole;
  }
  return plan;
}

TEST(HolesThatTouchTest, FindsHolesOnTheTwoSidesOfASeamSegment) {
  const Plan plan = HolesWith({{{0, 1, true}}, {{7, 8, true}, {1, 0, true}}, {{8, 7, true}}});
  EXPECT_EQ(HolesThatTouch(plan), (Pairs{{0, 1}, {1, 2}}));
}

TEST(HolesThatTouchTest, NamesAPairOnce) {
  const Plan plan = HolesWith({{{0, 1, true}, {1, 2, true}}, {{2, 1, true}, {1, 0, true}}});
  EXPECT_EQ(HolesThatTouch(plan), (Pairs{{0, 1}}));
}

TEST(HolesThatTouchTest, LeavesOutOriginalEdgesAndHolesThatFailed) {
  Plan plan = HolesWith({{{0, 1, true}, {3, 4, false}}, {{1, 0, true}}, {{4, 3, false}}});
  plan.holes[1].failure = "it folds";
  EXPECT_TRUE(HolesThatTouch(plan).empty());
}

TEST(HolesThatTouchTest, DoesNotDependOnTheOrderOfSegments) {
  Plan plan = HolesWith({{{0, 1, true}, {1, 2, true}, {5, 6, true}}, {{2, 1, true}}, {{6, 5, true}}});
  const Pairs before = HolesThatTouch(plan);
  std::reverse(plan.holes[0].segments.begin(), plan.holes[0].segments.end());
  EXPECT_EQ(HolesThatTouch(plan), before);
}

// Two independent tiles: each hole has a seam of its own along the border, at these places.
Pairs Facing(double a0, double a1, double b0, double b1) {
  Plan plan = HolesWith({{{0, 1, true}}, {{3, 2, true}}});
  for (const double y : {a0, a1, b0, b1}) {
    plan.vertices.emplace_back();
    plan.vertices.back().position = Point3(10, y, 0);
  }
  plan.seams = {{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {2, 3}}};
  return HolesThatFace(plan);
}

TEST(HolesThatFaceTest, FindsHolesWhoseSeamsOverlapAlongABorder) {
  EXPECT_EQ(Facing(1, 5, 3, 8), (Pairs{{0, 1}}));
  EXPECT_EQ(Facing(1, 9, 3, 8), (Pairs{{0, 1}}));
}

TEST(HolesThatFaceTest, LeavesHolesThatLieApart) {
  EXPECT_TRUE(Facing(1, 3, 3, 8).empty());
  EXPECT_TRUE(Facing(6, 8, 1, 2).empty());
}

TEST(HolesThatFaceTest, LooksAlongOneBorderAtATime) {
  Plan plan = HolesWith({{{0, 1, true}}, {{3, 2, true}}});
  for (const double y : {1, 5, 2, 6}) {
    plan.vertices.emplace_back();
    plan.vertices.back().position = Point3(10, y, 0);
  }
  plan.seams = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {2, 0}, {2, 3}}};
  EXPECT_TRUE(HolesThatFace(plan).empty());
}

}  // namespace
}  // namespace tilemend
