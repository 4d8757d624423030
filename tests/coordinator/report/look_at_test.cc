#include "coordinator/report/look_at.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;
using Verdict = HoleEvidence::Verdict;

class LookAtTest : public ::testing::Test {
 protected:
  LookAtTest() {
    input_.plan = &plan_;
    plan_.water_answers.resize(1);
  }

  // A judged hole of that area, with that much of original rim.
  void Add(const HoleEvidence& evidence, double area, double rim) {
    PlannedHole hole;
    hole.area = area;
    hole.perimeter = rim;
    hole.evidence = static_cast<int32_t>(plan_.evidence.size());
    plan_.holes.push_back(hole);
    plan_.evidence.push_back(evidence);
  }

  Plan plan_;
  SceneReportInput input_;
};

TEST_F(LookAtTest, LeavesOutWhatIsSure) {
  Add({Verdict::kLake, true, 3.25, 0.02, "the sides agree"}, 5000, 400);
  Add({Verdict::kNoWater, true, 3.25, 0.9, "the sides differ"}, 900, 200);
  EXPECT_EQ(LookAtJson(input_), Json::array());
}

TEST_F(LookAtTest, SaysWhichLevelIsDoubtful) {
  Add({Verdict::kLake, true, 3.25, 0.3, "the sides agree"}, 5000, 400);
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["hole"], 0);
  EXPECT_EQ(rows[0]["taken_for"], "lake");
  EXPECT_EQ(rows[0]["sigma_m"], 0.3);
  EXPECT_THAT(rows[0]["why"], HasSubstr("0.30 m"));
}

// As on a meadow that a polygon calls water.
TEST_F(LookAtTest, NamesADoubtfulLevelOfAPolygon) {
  HoleEvidence given = {Verdict::kLake, true, 417.7, 0.7, "feature 0 says that it is water"};
  given.area = 0;
  Add(given, 200, 5);
  given.sigma = std::nullopt;  // its level is the user's
  Add(given, 200, 5);
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["hole"], 0);
  EXPECT_EQ(rows[0]["why"], "the standard deviation of its level is 0.70 m; a polygon with level_m can set the level");
}

TEST_F(LookAtTest, NamesAPolygonThatIsLikelyWrong) {
  HoleEvidence given = {Verdict::kLake, true, 45, std::nullopt, "feature 0 says that it is water"};
  given.area = 0;
  Add(given, 200, 60);
  plan_.water_answers[0].doubt = "its level_m puts the water of hole 0 at (1, 2) 45.0 m above its shore";
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["why"], plan_.water_answers[0].doubt);
}

TEST_F(LookAtTest, SaysWhereTheRimIsShorterThanACircle) {
  Add({Verdict::kLevelGround, true, 3.25, 0.02, "noise"}, 314.2, 62);  // a circle of 10 m has 62.8 m
  Add({Verdict::kLevelGround, true, 3.25, 0.02, "noise"}, 314.1, 63);
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_THAT(rows[0]["why"], HasSubstr("62 m of rim"));
}

TEST_F(LookAtTest, TheRimOfAPartDoesNotTellTheLevelOfTheWholeScene) {
  HoleEvidence part = {Verdict::kLake, true, 3.25, 0.02, "the sides agree"};
  part.is_of_whole_scene = true;
  Add(part, 314.2, 10);
  EXPECT_EQ(LookAtJson(input_), Json::array());
}

TEST_F(LookAtTest, ListsLargeGroundTheLargestFirst) {
  Add({Verdict::kNoWater, false, 0, 0.0, "no rim"}, 1000, 200);
  Add({Verdict::kLevelGround, true, 1, 0.02, "noise"}, 2000, 200);
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["hole"], 1);
  EXPECT_EQ(rows[1]["hole"], 0);
}

TEST_F(LookAtTest, NamesAllHolesWhoseAreasItSums) {
  Add({Verdict::kNoWater, false, 0, 0.0, "no rim"}, 900.02, 200);
  for (const double area : {1652.9, 0.31, 70.0}) {
    PlannedHole hole;
    hole.area = area;
    hole.evidence = 0;
    plan_.holes.push_back(hole);
  }
  input_.outcome.failures = {{3, "no way was found"}};
  const Json rows = LookAtJson(input_);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0]["hole"], 1);
  EXPECT_EQ(rows[0]["holes"], Json({0, 1, 2}));
  EXPECT_EQ(rows[0]["area_m2"], 2553.2);
}

TEST_F(LookAtTest, LeavesOutWhatAReviewerAccepted) {
  Add({Verdict::kNoWater, true, 1, 0.02, "the sides differ"}, 5000, 400);
  Add({Verdict::kLake, true, 3.25, 0.3, "the sides agree"}, 5000, 20);
  EXPECT_EQ(LookAtJson(input_).size(), 2U);
  plan_.decisions = {{0, 0}, {1, 0}};
  plan_.water_answers[0].decision = ReviewDecision::kAccept;
  EXPECT_EQ(LookAtJson(input_), Json::array());
  plan_.water_answers[0].decision = ReviewDecision::kWater;
  EXPECT_EQ(LookAtJson(input_).size(), 2U) << "a decision that changed the fill";
  plan_.water_answers[0].decision = ReviewDecision::kAccept;
  plan_.water_answers[0].doubt = "it covers 40 % of the hole";
  EXPECT_EQ(LookAtJson(input_)[0]["why"], "it covers 40 % of the hole");
}

TEST_F(LookAtTest, LeavesOutWhatTheUserDecidedAndWhatStaysOpen) {
  HoleEvidence given = {Verdict::kLake, true, 3.25, std::nullopt, "a polygon says so"};
  given.area = 0;
  Add(given, 5000, 20);
  Add({Verdict::kNoWater, true, 1, 0.02, "the sides differ"}, 5000, 400);
  input_.outcome.failures = {{1, "no way was found"}};
  EXPECT_EQ(LookAtJson(input_), Json::array());
}

}  // namespace
}  // namespace tilemend
