#include "coordinator/plan/water/decided_holes.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/plan/water/water_answers.h"

namespace tilemend {
namespace {

std::vector<Point2> BoxOf(double x0, double x1) { return {{x0, 0}, {x1, 0}, {x1, 10}, {x0, 10}}; }

// A lake over two cells at x from 0 to 20, and a closed hole from 50 to 60.
class DecideHolesTest : public ::testing::Test {
 protected:
  DecideHolesTest() {
    AddHole(HoleKind::kOpenI, BoxOf(0, 10), 0);
    AddHole(HoleKind::kClosed, BoxOf(50, 60), -1);
    AddHole(HoleKind::kOpenI, BoxOf(10, 20), 0);
  }

  void AddHole(HoleKind kind, const std::vector<Point2>& ring, int32_t cluster) {
    const auto base = static_cast<int32_t>(plan_.vertices.size());
    PlannedHole& hole = plan_.holes.emplace_back();
    hole.kind = kind;
    hole.cluster = cluster;
    hole.area = 100;
    for (int32_t i = 0; i < 4; ++i) {
      plan_.vertices.push_back({{0, 0}, i, {ring[i].x(), ring[i].y(), 0}});
      hole.segments.push_back({base + i, base + (i + 1) % 4});
    }
  }
  static WaterArea Decision(ReviewDecision decision, double x0, double x1) {
    WaterArea area;
    area.water = decision == ReviewDecision::kWater;
    area.decision = decision;
    area.polygon.rings = {BoxOf(x0, x1)};
    area.label = "mark";
    return area;
  }
  std::vector<int32_t> Decide(const std::vector<WaterArea>& areas) {
    DecideHoles(areas, plan_);
    std::vector<int32_t> decisions;
    for (size_t h = 0; h < plan_.holes.size(); ++h) {
      const auto found = plan_.decisions.find(static_cast<int32_t>(h));
      decisions.push_back(found == plan_.decisions.end() ? -1 : found->second);
    }
    return decisions;
  }
  std::vector<WaterAnswer> Answer(const std::vector<WaterArea>& areas) {
    WaterOptions options;
    options.areas = areas;
    Decide(areas);
    AnswerWaterAreas(options, plan_);
    return plan_.water_answers;
  }

  Plan plan_;
};

TEST_F(DecideHolesTest, ADecisionOnOneHoleIsNotOnThoseAboveIt) {
  AddHole(HoleKind::kClosed, BoxOf(2, 4), -1);    // in a roof above the lake
  AddHole(HoleKind::kClosed, BoxOf(52, 59), -1);  // above the closed hole, and nearly as large
  const WaterArea lake = Decision(ReviewDecision::kOpen, 0, 20), hole = Decision(ReviewDecision::kOpen, 50, 60);
  EXPECT_EQ(Decide({lake, hole}), (std::vector{0, 1, 0, -1, -1}));
  EXPECT_EQ(plan_.holes[3].failure, "");
  EXPECT_EQ(plan_.holes[4].failure, "");
}

TEST_F(DecideHolesTest, ADecisionOnManyHolesIsOnEach) {
  AddHole(HoleKind::kClosed, BoxOf(22, 24), -1);
  AddHole(HoleKind::kClosed, BoxOf(30, 32), -1);
  EXPECT_EQ(Decide({Decision(ReviewDecision::kOpen, -5, 100)}), (std::vector{0, 0, 0, 0, 0}));
}

TEST_F(DecideHolesTest, ADecisionIsOnAllHolesOfACluster) {
  EXPECT_EQ(Decide({Decision(ReviewDecision::kGround, 0, 20)}), (std::vector{0, -1, 0}));
  for (const PlannedHole& hole : plan_.holes) EXPECT_EQ(hole.failure, "");
}

TEST_F(DecideHolesTest, LessThanHalfOfAClusterDecidesNothing) {
  EXPECT_EQ(Decide({Decision(ReviewDecision::kOpen, 0, 9)}), (std::vector{-1, -1, -1}));
}

TEST_F(DecideHolesTest, DecisionsThatSayTheSameDecideTogether) {
  EXPECT_EQ(Decide({Decision(ReviewDecision::kOpen, 0, 10), Decision(ReviewDecision::kOpen, 10, 20)}),
            (std::vector{0, -1, 0}));
  EXPECT_EQ(plan_.holes[0].failure, kLeftByDecision);
  EXPECT_EQ(plan_.holes[2].failure, kLeftByDecision);
}

TEST_F(DecideHolesTest, DecisionsThatContradictEachOtherDecideNothing) {
  const std::vector<WaterArea> areas = {Decision(ReviewDecision::kOpen, 0, 10),
                                        Decision(ReviewDecision::kGround, 10, 20)};
  EXPECT_EQ(Decide(areas), (std::vector{-1, -1, -1}));
  WaterOptions options;
  options.areas = areas;
  AnswerWaterAreas(options, plan_);
  ASSERT_EQ(plan_.water_answers.size(), 2U);
  for (const WaterAnswer& answer : plan_.water_answers) {
    EXPECT_FALSE(answer.taken);
    EXPECT_NE(answer.reason, "");
  }
}

TEST_F(DecideHolesTest, TheLastOneDecides) {
  EXPECT_EQ(Decide({Decision(ReviewDecision::kOpen, 0, 99), Decision(ReviewDecision::kAccept, 49, 61)}),
            (std::vector{0, 1, 0}));
  EXPECT_EQ(plan_.holes[1].failure, "");
  EXPECT_EQ(plan_.holes[2].failure, kLeftByDecision);
}

TEST_F(DecideHolesTest, AHoleThatCannotBeFilledKeepsItsReason) {
  plan_.holes[1].failure = "its boundary crosses itself";
  Decide({Decision(ReviewDecision::kOpen, 49, 61)});
  EXPECT_EQ(plan_.decisions.at(1), 0);
  EXPECT_EQ(plan_.holes[1].failure, "its boundary crosses itself");
}

TEST_F(DecideHolesTest, OnceItIsCancelledNothingIsDecided) {
  DecideHoles({Decision(ReviewDecision::kOpen, 0, 99)}, plan_, [] { return true; });
  EXPECT_TRUE(plan_.decisions.empty());
}

TEST_F(DecideHolesTest, AreasOfWaterAreNoDecisions) {
  WaterArea water;
  water.polygon.rings = {BoxOf(0, 99)};
  EXPECT_EQ(Decide({water}), (std::vector{-1, -1, -1}));
}

TEST_F(DecideHolesTest, ADecisionThatMatchesNoHoleIsAnswered) {
  WaterOptions options;
  options.areas = {Decision(ReviewDecision::kAccept, 49, 61), Decision(ReviewDecision::kAccept, 200, 210),
                   Decision(ReviewDecision::kGround, 0, 9), Decision(ReviewDecision::kOpen, 0, 20)};
  Decide(options.areas);
  AnswerWaterAreas(options, plan_);
  ASSERT_EQ(plan_.water_answers.size(), 4U);
  EXPECT_TRUE(plan_.water_answers[0].taken);
  EXPECT_EQ(plan_.water_answers[0].decision, ReviewDecision::kAccept);
  EXPECT_FALSE(plan_.water_answers[1].taken);
  EXPECT_EQ(plan_.water_answers[1].reason, "no hole lies under it");
  EXPECT_FALSE(plan_.water_answers[2].taken);
  EXPECT_EQ(plan_.water_answers[2].reason,
            "it covers 45 % of holes 0 and 2, which are decided on together; to decide on them, draw it over more than "
            "half of their area, or give each of them the same decision");
  EXPECT_TRUE(plan_.water_answers[3].taken);
}

TEST_F(DecideHolesTest, AnAnswerIsTakenOnlyWhereItDecides) {
  AddHole(HoleKind::kClosed, BoxOf(2, 4), -1);  // in a roof above the lake
  plan_.holes.back().area = 20;
  const WaterAnswer answer = Answer({Decision(ReviewDecision::kOpen, 0, 9)})[0];
  EXPECT_TRUE(plan_.decisions.empty());
  EXPECT_FALSE(answer.taken);
  EXPECT_NE(answer.reason.find("it covers 45 % of holes 0 and 2"), std::string::npos) << answer.reason;
  EXPECT_EQ(answer.doubt,
            "it does not decide on hole 3 at (0, 0), as most of it lies in another; draw one over that hole alone");
}

TEST_F(DecideHolesTest, ADecisionThatIsTakenIsSilentOnTheHolesAboveIt) {
  AddHole(HoleKind::kClosed, BoxOf(2, 4), -1);
  AddHole(HoleKind::kClosed, BoxOf(15, 30), -1);
  plan_.holes[3].area = 20;
  plan_.holes[4].area = 150;
  for (const WaterAnswer& answer :
       Answer({Decision(ReviewDecision::kOpen, 0, 20), Decision(ReviewDecision::kGround, 2, 4)})) {
    EXPECT_TRUE(answer.taken) << answer.reason;
    EXPECT_EQ(answer.doubt, "");
  }
}

TEST_F(DecideHolesTest, ADecisionOnAHoleAndPartOfAClusterNamesThePart) {
  WaterArea area = Decision(ReviewDecision::kOpen, 50, 60);
  area.polygon.rings.push_back(BoxOf(11, 20));
  area.polygon.rings.push_back(BoxOf(200, 210));  // so that most of it lies in no hole
  const WaterAnswer answer = Answer({area})[0];
  EXPECT_EQ(plan_.decisions, (std::map<int32_t, int32_t>{{1, 0}}));
  EXPECT_EQ(answer.holes, std::vector<int32_t>{1});
  EXPECT_EQ(answer.reason, "");
  EXPECT_NE(answer.doubt.find("it covers 45 % of holes 0 and 2"), std::string::npos) << answer.doubt;
}

TEST_F(DecideHolesTest, ADecisionOnMostOfAClusterSaysHowMuchLiesOutside) {
  const WaterAnswer open = Answer({Decision(ReviewDecision::kOpen, 0, 15)})[0];
  EXPECT_TRUE(open.taken);
  EXPECT_EQ(open.doubt, "it decides on 200 m2, and 50 m2 of that lie outside it, as the hole goes on there");
}

TEST_F(DecideHolesTest, DecisionsTogetherHaveNoDoubt) {
  for (const ReviewDecision decision : {ReviewDecision::kOpen, ReviewDecision::kAccept}) {
    for (const WaterAnswer& answer : Answer({Decision(decision, 0, 10), Decision(decision, 10, 20)})) {
      EXPECT_TRUE(answer.taken) << answer.reason;
      EXPECT_EQ(answer.doubt, "");
    }
    plan_.decisions.clear();
    plan_.water_answers.clear();
  }
}

// A hole in a lantern over the lake.
TEST_F(DecideHolesTest, AreasAreNotAboutHolesThatHangOverWhatTheyAreAbout) {
  AddHole(HoleKind::kClosed, BoxOf(6, 7), -1);
  plan_.holes[3].standing = Standing::kHanging;
  EXPECT_EQ(Decide({Decision(ReviewDecision::kWater, -30, 50)}), (std::vector<int32_t>{0, -1, 0, -1}));
  plan_.decisions.clear();
  EXPECT_EQ(Decide({Decision(ReviewDecision::kOpen, 6, 7)}), (std::vector<int32_t>{-1, -1, -1, 0}));
  plan_.decisions.clear();
  WaterArea lake;
  lake.water = true;
  lake.polygon.rings = {BoxOf(-1, 30)};
  const std::vector<WaterArea> areas = {lake};
  EXPECT_EQ(DeciderOf(plan_, {3}, areas, AreaIndex(areas, {})), std::nullopt);
  plan_.holes[3].standing = Standing::kElse;
  EXPECT_EQ(DeciderOf(plan_, {3}, areas, AreaIndex(areas, {})), 0U);
}

// Who accepts a fill leaves it to the area that decided on it.
TEST_F(DecideHolesTest, AnAcceptedHoleIsStillThatOfItsArea) {
  WaterArea dry;
  dry.water = false;
  dry.polygon.rings = {BoxOf(49, 61)};
  WaterOptions options;
  options.areas = {dry, Decision(ReviewDecision::kAccept, 49, 61)};
  Decide(options.areas);
  AnswerWaterAreas(options, plan_);
  EXPECT_TRUE(plan_.water_answers[0].taken) << plan_.water_answers[0].reason;
  EXPECT_TRUE(plan_.water_answers[1].taken);
}

}  // namespace
}  // namespace tilemend
