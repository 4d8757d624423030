#include "coordinator/report/plan_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(PlanWarningsTest, TenAreasThatAreNotTakenAreNamedAndTheRestCounted) {
  Plan plan;
  plan.water_answers.assign(25, {"feature", true, false, {}, "no hole lies under it"});
  plan.water_answers[3].taken = true;
  plan.water_answers[3].holes = {0};
  plan.water_answers[3].reason.clear();
  const auto warnings = PlanWarnings(plan);
  ASSERT_THAT(warnings, SizeIs(11));
  EXPECT_THAT(warnings.back(), HasSubstr("24 of 25 polygons are not taken"));
}

TEST(PlanWarningsTest, SaysThatNoHoleLiesInTheArea) {
  Plan plan;
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
  plan.has_polygon = true;
  EXPECT_THAT(PlanWarnings(plan), ElementsAre("no hole lies in the area, so nothing is filled"));
  plan.left.emplace_back();
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
  plan.left.clear();
  plan.holes.emplace_back();
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
}

}  // namespace
}  // namespace tilemend
