#include "coordinator/report/scene_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/util/version.h"
#include "coordinator/report/left_open.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::json;

PlannedHole Hole(CellId cell, HoleKind kind, HoleType type = HoleType::kNone) {
  PlannedHole hole;
  hole.cell = cell;
  hole.kind = kind;
  hole.type = type;
  hole.area = 10.00049;
  hole.boundary_vertices = 7;
  if (kind != HoleKind::kClosed) {
    hole.cluster = 0;
    hole.layer = 1;
  }
  return hole;
}

// A closed hole, a cluster of two open holes, and a closed hole that the plan finds fault with.
class SceneReportTest : public ::testing::Test {
 protected:
  SceneReportTest() {
    plan_.holes = {Hole({0, 0}, HoleKind::kClosed), Hole({0, 0}, HoleKind::kOpenI, HoleType::kB),
                   Hole({1, 0}, HoleKind::kOpenII, HoleType::kD), Hole({1, 0}, HoleKind::kClosed)};
    plan_.holes[0].single = SingleType::kCrack;
    plan_.holes[3].failure = "its boundary crosses itself";
    plan_.left = {{{1, 0}, "its boundary crosses itself", 3, 7}};
    plan_.clusters = plan_.layers = 1;
    input_.plan = &plan_;
    input_.cells = 2;
    input_.outcome.sizes = {{0, {11, 22}}, {1, {33, 44}}};
    input_.outcome.failures = {{2, "no way was found"}};
  }
  Json Report() const { return Json::parse(SceneReport(input_)); }

  Plan plan_;
  SceneReportInput input_;
};

TEST_F(SceneReportTest, CountsHolesByKindAndTypeFoundAndFilled) {
  const Json report = Report();
  EXPECT_EQ(report["cells"], 2);
  EXPECT_EQ(report["holes"]["closed"], 2);
  EXPECT_EQ(report["holes"]["I"]["B"], 1);
  EXPECT_EQ(report["holes"]["II"]["D"], 1);
  EXPECT_EQ(report["filled"]["closed"], 1);
  EXPECT_EQ(report["filled"]["I"]["B"], 1);
  EXPECT_EQ(report["filled"]["II"]["D"], 0);
  EXPECT_EQ(report["single"]["crack"], 1);
}

TEST_F(SceneReportTest, HasARowForEveryHoleInTheOrderOfThePlan) {
  const Json rows = Report()["per_hole"];
  ASSERT_EQ(rows.size(), 4U);
  for (int h = 0; h < 4; ++h) EXPECT_EQ(rows[h]["id"], h);
  EXPECT_EQ(rows[0]["outcome"], "filled");
  EXPECT_EQ(rows[0]["new_vertices"], 11);
  EXPECT_EQ(rows[0]["triangles"], 22);
  EXPECT_EQ(rows[0]["area_m2"], 10.0);
  EXPECT_FALSE(rows[0].contains("cluster"));
  EXPECT_EQ(rows[1]["cluster"], 0);
  EXPECT_EQ(rows[2]["outcome"], "left");
  EXPECT_EQ(rows[2]["reason"], "no way was found");
  EXPECT_FALSE(rows[2].contains("triangles"));
  EXPECT_EQ(rows[3]["reason"], "its boundary crosses itself");
}

TEST_F(SceneReportTest, OfHolesThatAreLeftTheRimTellsTheHeightAndTheAreaMayNotBeKnown) {
  plan_.upright = true;
  plan_.vertices.resize(2);
  plan_.vertices[0].position = {0, 0, 1};
  plan_.vertices[1].position = {4, 0, 2};
  for (PlannedHole& hole : plan_.holes) hole.segments = {{0, 1, false}, {1, 0, false}};
  plan_.holes[2].area = 0;
  const Json rows = Report()["per_hole"];
  EXPECT_FALSE(rows[0].contains("rim_height_m"));
  EXPECT_EQ(rows[2]["rim_height_m"], 1.5);
  EXPECT_TRUE(rows[2]["area_m2"].is_null());
  EXPECT_EQ(rows[3]["area_m2"], 10.0);
}

TEST_F(SceneReportTest, OfHolesThatAreFilledTheRimTellsHowFarItReachesUpAndDown) {
  plan_.upright = true;
  plan_.vertices.resize(4);
  plan_.vertices[0] = {{0, 0}, 5, {0, 0, 1.25}};
  plan_.vertices[1] = {{0, 0}, 6, {4, 0, -2}};
  plan_.vertices[2].position = {4, 4, 9};  // new ones, whose height is not known yet
  plan_.vertices[3].position = {4, 8, 9};
  plan_.holes[0].segments = {{0, 1, false}, {1, 2, true}, {2, 0, true}};
  plan_.holes[1].segments = {{2, 3, true}, {3, 2, true}};
  plan_.holes[2].segments = {{0, 1, false}, {1, 0, false}};
  const Json rows = Report()["per_hole"];
  EXPECT_EQ(rows[0]["rim_heights_m"], Json({-2, 1.25}));
  EXPECT_TRUE(rows[1].contains("rim_heights_m"));
  EXPECT_TRUE(rows[1]["rim_heights_m"].is_null());
  EXPECT_FALSE(rows[2].contains("rim_heights_m"));
  plan_.upright = false;
  EXPECT_FALSE(Report()["per_hole"][0].contains("rim_heights_m"));
}

TEST_F(SceneReportTest, TellsWhatIsLeftOfThePlanThenOfTilesThenOfHoles) {
  input_.outcome.unwritten = {{{0, 0}, "the tile is not written: disk", -1, 0}};
  const Json left = Report()["left"];
  ASSERT_EQ(left.size(), 3U);
  EXPECT_EQ(left[0]["hole"], 3);
  EXPECT_EQ(left[1]["reason"], "the tile is not written: disk");
  EXPECT_FALSE(left[1].contains("hole"));
  EXPECT_EQ(left[2]["hole"], 2);
  EXPECT_EQ(left[2]["open_edges"], 7);
}

TEST_F(SceneReportTest, ListsTilesThatAreNotWrittenByCell) {
  input_.outcome.unwritten = {{{2, 0}, "disk"}, {{0, 1}, "disk"}, {{1, 0}, "disk"}};
  const Json left = Report()["left"];
  ASSERT_EQ(left.size(), 5U);
  EXPECT_EQ(left[1]["cell"], Json::parse("[0, 1]"));
  EXPECT_EQ(left[2]["cell"], Json::parse("[1, 0]"));
  EXPECT_EQ(left[3]["cell"], Json::parse("[2, 0]"));
}

// Nothing is open there.
TEST_F(SceneReportTest, WarnsOfLostResultsWithoutWhichACellWasFilled) {
  const size_t left = Report()["left"].size(), warnings = Report()["warnings"].size();
  input_.outcome.impaired = {{{1, 0}, "a seam is not smoothed: b"}, {{0, 0}, "a seam is not smoothed: a"}};
  const Json report = Report();
  EXPECT_EQ(report["left"].size(), left);
  EXPECT_TRUE(IsPartial(input_));
  ASSERT_EQ(report["warnings"].size(), warnings + 2);
  EXPECT_THAT(report["warnings"].dump(), ::testing::HasSubstr(R"("cell +000_+000: a seam is not smoothed: a",)"
                                                              R"("cell +001_+000: a seam is not smoothed: b")"));
}

TEST_F(SceneReportTest, CountsWhatIsOpenByRightButDoesNotListIt) {
  plan_.left.push_back({{0, 0}, "an outline", -1, 12, false});
  plan_.left.push_back({{1, 0}, "an outline", -1, 3, false});
  plan_.left.push_back({{1, 0}, "a rag", -1, 1, false});
  const Json report = Report();
  EXPECT_EQ(report["left"].size(), 2U);
  EXPECT_EQ(report["not_holes"], Json::parse(R"([{"what": "a rag", "count": 1, "open_edges": 1},
                                                {"what": "an outline", "count": 2, "open_edges": 15}])"));
}

TEST_F(SceneReportTest, SaysOfWhatWithWhatAndWhenItIsMade) {
  input_.scene = "/data/city";
  input_.date = "2026-11-22T05:10:00Z";
  input_.options = {{"surface", "wang"}, {"gradation", 1.5}, {"uniform", true}};
  const Json report = Report();
  EXPECT_EQ(report["version"], Version());
  EXPECT_EQ(report["scene"], "/data/city");
  EXPECT_EQ(report["date"], "2026-11-22T05:10:00Z");
  EXPECT_EQ(report["options"], Json::parse(R"({"surface": "wang", "gradation": 1.5, "uniform": true})"));
}

TEST_F(SceneReportTest, NamesWaterAndItsLevel) {
  plan_.holes[1].water = 0;
  input_.outcome.sizes[1].way = FillWay::kWater;
  plan_.water = {{BodyKind::kWater, {1}, 12.5, {}, {}, 0.01, 12.4, 12.6, 9, false}};
  const Json report = Report();
  EXPECT_EQ(report["per_hole"][1]["method"], "water");
  EXPECT_EQ(report["per_hole"][1]["level_m"], 12.5);
  EXPECT_FALSE(report["per_hole"][0].contains("level_m"));
  EXPECT_EQ(report["water"][0]["level_m"], 12.5);
  EXPECT_EQ(report["water"][0]["holes"], Json::array({1}));
  EXPECT_EQ(report["water"][0]["decided_by"], "rim");
}

TEST_F(SceneReportTest, LevelGroundIsNoWater) {
  plan_.holes[1].water = 0;
  plan_.water = {{BodyKind::kLevelGround, {1}, 12.5, {}, {}}};
  input_.outcome.sizes[1].way = FillWay::kFoldsCut;
  const Json report = Report();
  EXPECT_TRUE(report["water"].empty());
  EXPECT_EQ(report["per_hole"][1]["method"], "level ground");
  EXPECT_EQ(report["per_hole"][1]["folds_cut"], true);
  EXPECT_EQ(report["per_hole"][1]["level_m"], 12.5);
}

TEST_F(SceneReportTest, OpenHolesAreFilledOverTheGroundAlsoWithFoldsCutOff) {
  for (auto& [hole, size] : input_.outcome.sizes) size.way = FillWay::kFoldsCut;
  const Json rows = Report()["per_hole"];
  EXPECT_EQ(rows[0]["method"], "folds cut off");
  EXPECT_EQ(rows[1]["method"], "over the ground, folds cut off");
}

TEST_F(SceneReportTest, SaysWhatAHoleWasTakenForAndWhy) {
  plan_.holes[1].evidence = 0;
  plan_.holes[2].evidence = 1;
  plan_.evidence = {{HoleEvidence::Verdict::kLake, true, 12.5, 0.04, "the sides agree"}, {}};
  plan_.evidence[1].reason = "no rim";
  const Json rows = Report()["per_hole"];
  EXPECT_FALSE(rows[0].contains("water"));
  EXPECT_EQ(rows[1]["water"],
            Json::parse(R"({"taken_for": "lake", "level_m": 12.5, "sigma_m": 0.04, "reason": "the sides agree"})"));
  EXPECT_EQ(rows[2]["water"], Json::parse(R"({"taken_for": "ground", "reason": "no rim"})"));
}

TEST_F(SceneReportTest, GivesHolesOfARiverTheLevelsOfItsEnds) {
  plan_.holes[1].water = 0;
  plan_.water.resize(1);
  plan_.water[0].level = 4.25;
  plan_.water[0].river.stations = {{0, 0, 5.5}, {1, 0, 5}, {2, 0, 4.25}};
  EXPECT_EQ(Report()["per_hole"][1]["level_m"], Json::array({5.5, 4.25}));
}

TEST_F(SceneReportTest, TellsTheTensionsThatWerePutToATest) {
  input_.outcome.of_clusters[0] = {0.5, 0.1, 0.2, 6};
  input_.outcome.of_holes[0] = {0.25, 0, 0, 0};                     // not tested
  input_.outcome.of_clusters[1] = {300, 0, 0, 0, {{0, 0}, 0.125}};  // ground with walls
  const Json report = Report();
  ASSERT_EQ(report["tension"].size(), 2U);
  EXPECT_EQ(report["tension"][0]["cluster"], 0);
  EXPECT_EQ(report["tension"][0]["tension"], 0.5);
  EXPECT_FALSE(report["tension"][0].contains("steepness"));
  EXPECT_EQ(report["tension"][1]["steepness"], 0.125);
}

TEST_F(SceneReportTest, TellsTheSecondsOfEachStep) {
  input_.seconds = {{"survey", 1.23456789}, {"plan", 2}};
  const Json report = Report();
  EXPECT_EQ(report["seconds"]["survey"], 1.234568);
  EXPECT_EQ(report["seconds"]["plan"], 2.0);
}

TEST_F(SceneReportTest, PutsTheWarningsOfThePlanAfterThoseGiven) {
  input_.warnings = {"first"};
  plan_.water_answers = {{"feature 4", true, false, {}, "no hole lies under it"}};
  EXPECT_THAT(Report()["warnings"].get<std::vector<std::string>>(),
              ElementsAre("first", "polygon feature 4 is not taken: no hole lies under it"));
}

TEST_F(SceneReportTest, WarnsOfPatchesThatFoldBack) {
  EXPECT_TRUE(WarningsOf(input_).empty());
  input_.outcome.sizes[0].creases = 3;
  EXPECT_THAT(WarningsOf(input_), ElementsAre("1 patch folds back, at 3 edges (creases)"));
}

TEST_F(SceneReportTest, WarnsOfPatchesThatCrossWhatPassesThroughTheirBoundary) {
  input_.outcome.sizes[0].rim_is_crossed = true;
  EXPECT_THAT(
      WarningsOf(input_),
      ElementsAre("1 patch crosses the surface, which passes through the boundary there: hole 0 (rim_crossed)"));
  EXPECT_EQ(Report()["per_hole"][0]["rim_crossed"], true);
  EXPECT_FALSE(Report()["per_hole"][0].contains("crossings"));
  input_.outcome.sizes[0].rim_is_crossed = false;
  input_.outcome.sizes[0].crossings = 3;
  EXPECT_THAT(WarningsOf(input_),
              ElementsAre("1 patch crosses itself or the surface beside it; `tilemend check` lists where, as faults or "
                          "crossed_rims: hole 0 (crossings)"));
  EXPECT_EQ(Report()["per_hole"][0]["crossings"], 3);
}

TEST_F(SceneReportTest, TextThatIsNotUtf8DoesNotBreakIt) {
  input_.outcome.failures[2] = "\xff";
  EXPECT_FALSE(Json::parse(SceneReport(input_), nullptr, false).is_discarded());
}

}  // namespace
}  // namespace tilemend
