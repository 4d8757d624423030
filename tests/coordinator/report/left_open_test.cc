#include "coordinator/report/left_open.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

class LeftOpenTest : public testing::Test {
 protected:
  LeftOpenTest() {
    plan_.holes.resize(2);
    plan_.holes[1].cell = {1, 0};
    plan_.left = {{{0, 0}, "an outline", -1, 4, false}};
    input_.plan = &plan_;
  }

  Plan plan_;
  SceneReportInput input_;
};

TEST_F(LeftOpenTest, OutlinesAreNoHoles) {
  EXPECT_EQ(LeftOf(input_).size(), 1u);
  EXPECT_FALSE(SomeHolesLeft(input_));
}

TEST_F(LeftOpenTest, BoundaryEdgesThatFormNoLoopCount) {
  plan_.left.push_back({{0, 0}, "no loop", -1, 3});
  EXPECT_TRUE(SomeHolesLeft(input_));
}

TEST_F(LeftOpenTest, HolesThatFailCountWhereTheirCellIsChosen) {
  input_.outcome.failures[1] = "a reason";
  EXPECT_EQ(FailureOf(input_, 0), "");
  EXPECT_EQ(FailureOf(input_, 1), "a reason");
  EXPECT_EQ(LeftOf(input_).size(), 2u);
  EXPECT_TRUE(SomeHolesLeft(input_));
  input_.outcome.chosen = {CellId{0, 0}};
  EXPECT_EQ(FailureOf(input_, 1), "in a cell that was not chosen");
  EXPECT_STREQ(OutcomeOf(FailureOf(input_, 1)), "not chosen");
  EXPECT_STREQ(OutcomeOf(FailureOf(input_, 0)), "filled");
  EXPECT_STREQ(OutcomeOf("a reason"), "left");
  EXPECT_FALSE(SomeHolesLeft(input_));
}

TEST_F(LeftOpenTest, ATinyHoleDoesNotMakeAnOutputPartial) {
  input_.outcome.failures[1] = "a reason";
  plan_.holes[1].area = 0.049;
  EXPECT_TRUE(SomeHolesLeft(input_));
  EXPECT_FALSE(IsPartial(input_));
  EXPECT_EQ(UncountedText(input_), "; 1 left open is smaller than 0.05 m2 and does not count");
  plan_.holes[1].area = 0.051;
  EXPECT_TRUE(IsPartial(input_));
  EXPECT_EQ(UncountedText(input_), "");
}

TEST_F(LeftOpenTest, AReportTellsWhatDoesNotCount) {
  const auto report = nlohmann::ordered_json::parse(R"({"per_hole": [
      {"area_m2": 0.01, "outcome": "left", "reason": "a reason"}, {"area_m2": -0.02, "outcome": "left"},
      {"area_m2": 0.01, "outcome": "filled"}, {"area_m2": null, "outcome": "left"}, {"area_m2": 9, "outcome": "left"},
      {"area_m2": 0.01, "outcome": "left", "reason": "left open by decision"},
      {"area_m2": 0.01, "outcome": "left", "reason": "in a cell that was not chosen"},
      {"area_m2": 0.01, "outcome": "not chosen", "reason": "in a cell that was not chosen"}]})");
  EXPECT_EQ(UncountedText(report),
            "; 5 left open, 2 of them smaller than 0.05 m2 and 1 by decision, which do not count");
  EXPECT_EQ(UncountedText(nlohmann::ordered_json()), "");
}

// A report with holes left open of those areas, and so many by decision.
nlohmann::ordered_json ReportOf(const std::vector<double>& areas, int decided) {
  nlohmann::ordered_json report;
  for (const double area : areas) {
    report["per_hole"].push_back({{"area_m2", area}, {"outcome", "left"}, {"reason", "a reason"}});
  }
  for (int k = 0; k < decided; ++k) {
    report["per_hole"].push_back({{"area_m2", 5}, {"outcome", "left"}, {"reason", "left open by decision"}});
  }
  return report;
}

TEST_F(LeftOpenTest, TheTextCountsAllThatIsLeftOpenWhereSomeCounts) {
  EXPECT_EQ(UncountedText(ReportOf({0.01, 1.3}, 0)),
            "; 2 left open, 1 of them smaller than 0.05 m2, which does not count");
  EXPECT_EQ(UncountedText(ReportOf({0.01, 0.02, 1.3}, 0)),
            "; 3 left open, 2 of them smaller than 0.05 m2, which do not count");
  EXPECT_EQ(UncountedText(ReportOf({1.3}, 1)), "; 2 left open, 1 of them by decision, which does not count");
  EXPECT_EQ(UncountedText(ReportOf({0.01, 0.02}, 1)),
            "; 2 left open are smaller than 0.05 m2 and do not count; 1 left open by decision does not count");
  EXPECT_EQ(UncountedText(ReportOf({1.3}, 0)), "");
}

TEST_F(LeftOpenTest, AJobCountsAllThatIsLeftOpenAsItsReportDoes) {
  input_.outcome.failures = {{0, "a reason"}, {1, "another"}};
  plan_.holes[0].area = 0.01;
  plan_.holes[1].area = 1.3;
  EXPECT_EQ(UncountedText(input_), "; 2 left open, 1 of them smaller than 0.05 m2, which does not count");
}

TEST_F(LeftOpenTest, AnAreaThatIsNotKnownCounts) {
  plan_.holes[1].kind = HoleKind::kOpenI;
  plan_.holes[1].failure = "no way along the grid line";
  plan_.left.push_back({{1, 0}, plan_.holes[1].failure, 1, 9});
  EXPECT_TRUE(IsPartial(input_));
  plan_.left.back().hole = -1;
  EXPECT_TRUE(IsPartial(input_));
}

TEST_F(LeftOpenTest, HolesThatThePlanGaveUpCount) {
  plan_.holes[0].failure = "no way along the grid line";
  EXPECT_TRUE(SomeHolesLeft(input_));
}

}  // namespace
}  // namespace tilemend
