#include "coordinator/report/plan_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coordinator/plan/types/left_reasons.h"

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
  plan.water_answers.emplace_back().decision = ReviewDecision::kOpen;
  EXPECT_THAT(PlanWarnings(plan).back(), HasSubstr("24 of 25 polygons are not taken"));
}

TEST(PlanWarningsTest, ADecisionIsNoPolygonForAReader) {
  Plan plan;
  plan.water_answers.assign(2, {"feature 0", true, false, {}, "no hole lies under it"});
  plan.water_answers[1].label = "decision on hole 4";
  plan.water_answers[1].decision = ReviewDecision::kWater;
  EXPECT_THAT(PlanWarnings(plan), ElementsAre("polygon feature 0 is not taken: no hole lies under it",
                                              "decision on hole 4 is not taken: no hole lies under it"));
}

// A reviewer made each of them.
TEST(PlanWarningsTest, EachDecisionWithoutEffectIsNamed) {
  Plan plan;
  plan.water_answers.assign(25, {"decision", false, false, {}, "no hole lies under it"});
  for (WaterAnswer& answer : plan.water_answers) answer.decision = ReviewDecision::kOpen;
  plan.water_answers[7].doubt = "it covers 16 % of holes 3 and 4";
  const auto warnings = PlanWarnings(plan);
  ASSERT_THAT(warnings, SizeIs(26));
  EXPECT_EQ(warnings[24], "decision is not taken: no hole lies under it");
  EXPECT_EQ(warnings[25], "decision: it covers 16 % of holes 3 and 4");
  plan.water_answers.assign(120, plan.water_answers[0]);
  ASSERT_THAT(PlanWarnings(plan), SizeIs(101));
  EXPECT_THAT(PlanWarnings(plan).back(), HasSubstr("120 decisions are not taken; the report lists all"));
}

TEST(PlanWarningsTest, NamesNumbersThatCannotBeMetresOrHeights) {
  Plan plan;
  plan.remarks.tiny_cell = 0.00018;
  plan.remarks.impossible_heights = {3, {1, 0}, -9999, 55.5};
  EXPECT_THAT(PlanWarnings(plan),
              ElementsAre(HasSubstr("the cells are 0.00018 wide, and numbers are taken for metres"),
                          HasSubstr("heights of 3 tiles lie further apart than any on Earth, in cell +001_+000 from "
                                    "-9999 to 55.5 m")));
}

TEST(CheckAreasTest, RefusesDecisionsOfWhichNoneHasAnEffect) {
  Plan plan;
  EXPECT_TRUE(CheckAreas(plan).ok());
  plan.water_answers.assign(3, {"feature", true, false, {}, "no hole lies under it"});
  for (WaterAnswer& answer : plan.water_answers) answer.is_over_hole = false;
  EXPECT_TRUE(CheckAreas(plan).ok());  // polygons of --water
  plan.water_answers[1].decision = plan.water_answers[2].decision = ReviewDecision::kAccept;
  const absl::Status refused = CheckAreas(plan);
  EXPECT_TRUE(absl::IsInvalidArgument(refused));
  EXPECT_THAT(std::string(refused.message()),
              HasSubstr("none of the 2 decisions applies: no hole lies under them; is the file of another scene?"));
  plan.water_answers[2].is_over_hole = true;
  plan.water_answers[2].reason = "it covers 34 % of holes 0 and 19";
  EXPECT_THAT(std::string(CheckAreas(plan).message()),
              HasSubstr("none of the 2 decisions has an effect; feature: it covers 34 % of holes 0 and 19"));
  plan.water_answers[1].taken = true;
  EXPECT_TRUE(CheckAreas(plan).ok());
}

TEST(CheckAreasTest, RefusesToClearAtARimThatIsNotKnown) {
  Plan plan;
  WaterAnswer& answer = plan.water_answers.emplace_back();
  answer.label = "feature 0";
  answer.reason = std::string("the hole that it covers is left: ") + kReachesUnknownRim;
  EXPECT_TRUE(CheckAreas(plan).ok()) << "nothing was taken out";
  answer.has_cleared = true;
  const absl::Status refused = CheckAreas(plan);
  EXPECT_TRUE(absl::IsInvalidArgument(refused));
  EXPECT_THAT(std::string(refused.message()), HasSubstr("feature 0: what it takes out reaches the rim of the area"));
}

TEST(PlanWarningsTest, SaysThatNoHoleLiesInTheArea) {
  Plan plan;
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
  plan.remarks.has_polygon = true;
  EXPECT_THAT(PlanWarnings(plan), ElementsAre("no hole lies in the area, so nothing is filled"));
  plan.left.emplace_back();
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
  plan.left.clear();
  plan.holes.emplace_back();
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
}

TEST(PlanWarningsTest, SaysHowFarTilesAreTurned) {
  Plan plan;
  plan.remarks.turn = 0.0178;
  EXPECT_THAT(PlanWarnings(plan), ElementsAre(HasSubstr("turned by 1.02 degrees")));
}

// A river over holes 0 and 1; hole 2 lies beyond the seam from vertex 1 to 2, and a lake in hole 3 touches it at
// vertex 5.
Plan RiverToTheRim() {
  Plan plan;
  plan.holes.resize(4);
  plan.holes[0].segments = {{0, 8}, {8, 0}};
  plan.holes[1].segments = {{0, 1}, {1, 2}, {2, 0}};
  plan.holes[2].segments = {{2, 1}, {1, 5}};
  plan.holes[3].segments = {{5, 6}, {6, 7}, {7, 5}};
  plan.holes[2].failure = kReachesUnknownRim;
  plan.water.resize(2);
  plan.water[0].holes = {0, 1};
  plan.water[1].holes = {3};
  return plan;
}

TEST(PlanWarningsTest, SaysThatLevelsOfWaterAtTheRimOfAnUnknownAreaAreDoubtful) {
  Plan plan = RiverToTheRim();
  const auto warnings = PlanWarnings(plan);
  ASSERT_THAT(warnings, SizeIs(1));
  EXPECT_THAT(warnings[0], HasSubstr("levels of 1 of 2 rivers and lakes are doubtful"));
  EXPECT_THAT(warnings[0], HasSubstr("(at hole 0)"));
  EXPECT_THAT(warnings[0], HasSubstr("--area FILE"));
  plan.holes[2].failure = "its boundary crosses itself seen from above";
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
}

TEST(PlanWarningsTest, NamesTenBodiesOfWaterAtTheRim) {
  Plan plan = RiverToTheRim();
  plan.water.assign(12, plan.water[0]);
  ASSERT_THAT(PlanWarnings(plan), SizeIs(1));
  EXPECT_THAT(PlanWarnings(plan)[0], HasSubstr("12 of 12 rivers"));
  EXPECT_THAT(PlanWarnings(plan)[0], HasSubstr("(at holes 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 and others)"));
}

TEST(PlanWarningsTest, SaysThatSinglePrecisionIsTooCoarse) {
  Plan plan;
  plan.lattice_step = 0x1p-10;
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
  plan.lattice_step = 0.25;
  EXPECT_THAT(PlanWarnings(plan), ElementsAre(HasSubstr("0.25 m apart")));
  plan.single_mesh = true;  // its step is that of its edges
  EXPECT_THAT(PlanWarnings(plan), IsEmpty());
}

}  // namespace
}  // namespace tilemend
