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

TEST(HolesThatTouchTest, WaterTouchesOnlyItsOwnBody) {
  Plan plan = HolesWith({{{0, 1, true}, {4, 5, true}}, {{1, 0, true}, {2, 3, true}}, {{3, 2, true}, {5, 4, true}}});
  plan.holes[0].water = plan.holes[1].water = 0;
  EXPECT_EQ(HolesThatTouch(plan), (Pairs{{0, 1}}));
}

TEST(HolesThatTouchTest, DoesNotDependOnTheOrderOfSegments) {
  Plan plan = HolesWith({{{0, 1, true}, {1, 2, true}, {5, 6, true}}, {{2, 1, true}}, {{6, 5, true}}});
  const Pairs before = HolesThatTouch(plan);
  std::reverse(plan.holes[0].segments.begin(), plan.holes[0].segments.end());
  EXPECT_EQ(HolesThatTouch(plan), before);
}

}  // namespace
}  // namespace tilemend
