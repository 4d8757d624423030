#include "coordinator/report/review_queue.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = HoleEvidence::Verdict;

class ReviewQueueTest : public ::testing::Test {
 protected:
  ReviewQueueTest() { input_.plan = &plan_; }

  // A judged hole of that area, with that much of original rim.
  HoleEvidence& Add(Verdict verdict, double sigma, double area, double rim) {
    PlannedHole& hole = plan_.holes.emplace_back();
    hole.area = area;
    hole.perimeter = rim;
    hole.evidence = static_cast<int32_t>(plan_.evidence.size());
    return plan_.evidence.emplace_back(HoleEvidence{verdict, true, 3.25, sigma, "because"});
  }
  double DoubtOf(size_t evidence) { return ReviewedGroups(input_)[evidence].doubt; }

  Plan plan_;
  SceneReportInput input_;
};

TEST_F(ReviewQueueTest, TheDoubtOfASureLevelIsItsDeviation) {
  Add(Verdict::kLake, 0.25, 500, 100);
  EXPECT_DOUBLE_EQ(DoubtOf(0), 0.25);
}

TEST_F(ReviewQueueTest, ARimShorterThanACircleTellsLess) {
  Add(Verdict::kLake, 0.25, 314.159265, 31.4159265);  // half a circle of 10 m
  EXPECT_NEAR(DoubtOf(0), 0.5, 1e-6);
  plan_.evidence[0].is_of_whole_scene = true;
  EXPECT_DOUBLE_EQ(DoubtOf(0), 0.25);
}

TEST_F(ReviewQueueTest, AVerdictThatMayBeWrongCountsTheOtherSurface) {
  HoleEvidence& evidence = Add(Verdict::kLake, 0.1, 500, 100);
  evidence.chance_wrong = 0.25;
  evidence.dry_difference = 2;
  EXPECT_DOUBLE_EQ(DoubtOf(0), 0.75 * 0.1 + 0.25 * 2);
}

TEST_F(ReviewQueueTest, OfGroundTheErrorIsThatOfTheHoldOut) {
  Add(Verdict::kNoWater, 0.9, 500, 100);
  EXPECT_EQ(DoubtOf(0), 0);
  input_.outcome.of_holes[0].error = 0.2;
  EXPECT_EQ(DoubtOf(0), 0) << "nothing was held out";
  input_.outcome.of_holes[0].blocks = 8;
  EXPECT_DOUBLE_EQ(DoubtOf(0), 0.2);
}

TEST_F(ReviewQueueTest, RanksByDoubtTimesArea) {
  Add(Verdict::kLake, 0.2, 100, 100);
  Add(Verdict::kLake, 0.1, 900, 120);
  Add(Verdict::kLake, 0.0, 5000, 400);
  const Json rows = ReviewJson(input_);
  ASSERT_EQ(rows.size(), 2U) << "what is sure is not in the queue";
  EXPECT_EQ(rows[0]["hole"], 1);
  EXPECT_EQ(rows[0]["doubt_m3"], 90);
  EXPECT_EQ(rows[0]["taken_for"], "lake");
  EXPECT_EQ(rows[1]["hole"], 0);
}

TEST_F(ReviewQueueTest, HolesOfOneClusterAreOneRow) {
  Add(Verdict::kLake, 0.2, 100, 100);
  PlannedHole second = plan_.holes[0];
  second.area = 300;
  plan_.holes.push_back(second);
  const Json rows = ReviewJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["hole"], 1);
  EXPECT_EQ(rows[0]["holes"], Json({0, 1}));
  EXPECT_EQ(rows[0]["area_m2"], 400);
  EXPECT_EQ(rows[0]["doubt_m3"], 80);
}

TEST_F(ReviewQueueTest, ARowCountsTheCrossingsOfItsHoles) {
  Add(Verdict::kLake, 0.2, 100, 100);
  plan_.holes.push_back(plan_.holes[0]);
  EXPECT_FALSE(ReviewJson(input_)[0].contains("crossings"));
  input_.outcome.sizes[0].crossings = 3;
  input_.outcome.sizes[1].crossings = 4;
  EXPECT_EQ(ReviewJson(input_)[0]["crossings"], 7);
}

TEST_F(ReviewQueueTest, WhatTheUserDecidedIsNotInDoubt) {
  Add(Verdict::kLake, 0.2, 100, 100).area = 0;
  Add(Verdict::kLake, 0.2, 100, 100);
  plan_.decisions[1] = 0;
  EXPECT_EQ(ReviewJson(input_), Json::array());
}

TEST_F(ReviewQueueTest, AGivenLevelFarFromTheShoreIsInDoubt) {
  Add(Verdict::kLake, 0.2, 100, 100).area = 0;
  plan_.holes[0].water = 0;
  WaterBody& body = plan_.water.emplace_back();
  body.level_is_given = true;
  body.shore_level = 3;
  for (const auto& [level, doubt] : {std::pair(3.9, 0.0), std::pair(48.0, 45.0), std::pair(-42.0, 45.0)}) {
    body.level = level;
    EXPECT_EQ(DoubtOf(0), doubt) << level;
  }
  body.level_is_given = false;
  EXPECT_EQ(DoubtOf(0), 0);
}

TEST_F(ReviewQueueTest, CellsThatWereNotChosenAreNotInTheQueue) {
  Add(Verdict::kLake, 0.2, 100, 100);
  input_.outcome.chosen = {{7, 7}};
  EXPECT_EQ(ReviewJson(input_), Json::array());
}

TEST(DecisionNameTest, IsTheWordOfTheFile) {
  EXPECT_EQ(std::string(DecisionName(ReviewDecision::kOpen)), "open");
  EXPECT_EQ(std::string(DecisionName(ReviewDecision::kAccept)), "accept");
}

}  // namespace
}  // namespace tilemend
