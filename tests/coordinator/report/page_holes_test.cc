#include "coordinator/report/page_holes.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

TEST(PageHolesTest, ShowsThoseThatWereLeftFirstThenTheLargest) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "kind": "closed", "single": "simple", "area_m2": -4, "outcome": "filled", "method": "plane"},
      {"id": 1, "kind": "open", "type": "B", "area_m2": 9, "outcome": "filled", "water": {"reason": "lake", "sigma_m": 0.1}},
      {"id": 2, "kind": "open", "area_m2": 1, "outcome": "left", "reason": "crossed"}]})");
  const Json holes = PageHoles(report, 10);
  ASSERT_EQ(holes.size(), 3);
  EXPECT_EQ(holes[0]["id"], 2);
  EXPECT_EQ(holes[0]["reason"], "crossed");
  EXPECT_EQ(holes[0]["filled"], false);
  EXPECT_EQ(holes[1]["kind"], "open B");
  EXPECT_EQ(holes[1]["sigma"], 0.1);
  EXPECT_EQ(holes[1]["reason"], "lake");
  EXPECT_EQ(holes[2]["kind"], "closed, simple");
  EXPECT_EQ(holes[2]["area"], 4);
  EXPECT_EQ(PageHoles(report, 1).size(), 1);
}

TEST(PageHolesTest, SaysWhatMakesTheOutputPartial) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "area_m2": 0, "outcome": "left", "reason": "crossed"},
      {"id": 1, "area_m2": 9, "outcome": "filled"},
      {"id": 2, "area_m2": null, "outcome": "left"}]})");
  for (const Json& hole : PageHoles(report, 10)) EXPECT_EQ(hole["counts"], hole["id"] == 2) << hole;
}

TEST(PageHolesTest, AnAreaThatIsNotKnownIsNone) {
  const Json report = Json::parse(R"({"per_hole": [{"id": 0, "area_m2": null, "outcome": "left"}]})");
  EXPECT_TRUE(PageHoles(report, 1)[0]["area"].is_null());
}

TEST(PageHolesTest, RanksThemByTheirDoubtBeforeTheirArea) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "area_m2": 9, "outcome": "filled"},
      {"id": 1, "area_m2": 5, "outcome": "filled", "doubt_m3": 1.5},
      {"id": 2, "area_m2": 4, "outcome": "filled", "doubt_m3": 2, "decision": "accept"}]})");
  const Json holes = PageHoles(report, 10);
  EXPECT_EQ(holes[0]["id"], 2);
  EXPECT_EQ(holes[0]["doubt"], 2);
  EXPECT_EQ(holes[0]["decision"], "accept");
  EXPECT_EQ(holes[1]["id"], 1);
  EXPECT_TRUE(holes[2]["doubt"].is_null());
}

// Else a decision on one of them could cover less than half of the cluster.
TEST(PageHolesTest, AFilledHoleComesWithItsCluster) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "area_m2": 1, "outcome": "filled", "cluster": 4},
      {"id": 1, "area_m2": 7, "outcome": "filled", "cluster": 4},
      {"id": 2, "area_m2": 8, "outcome": "filled", "cluster": 5},
      {"id": 3, "area_m2": 2, "outcome": "filled", "cluster": 5},
      {"id": 4, "area_m2": 3, "outcome": "filled", "cluster": -1},
      {"id": 5, "area_m2": 9, "outcome": "left", "cluster": 4},
      {"id": 6, "area_m2": 2, "outcome": "filled", "cluster": -1}]})");
  const auto ids = [&](size_t most) {
    std::vector<int> numbers;
    for (const Json& hole : PageHoles(report, most)) numbers.push_back(hole["id"].get<int>());
    return numbers;
  };
  EXPECT_EQ(ids(1), (std::vector{5}));
  EXPECT_EQ(ids(2), (std::vector{5, 2, 3})) << "one cluster more at most";
  EXPECT_EQ(ids(3), (std::vector{5, 2, 3}));
  EXPECT_EQ(ids(4), (std::vector{5, 2, 1, 3, 0}));
  EXPECT_EQ(ids(6), (std::vector{5, 2, 1, 4, 3, 0}));
  EXPECT_EQ(ids(7), (std::vector{5, 2, 1, 4, 3, 6, 0}));
}

TEST(PageHolesTest, SayWhatTheyWereTakenForIfTheyWereJudged) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "area_m2": 9, "outcome": "filled", "water": {"taken_for": "level ground", "level_m": 3.5}},
      {"id": 1, "area_m2": 5, "outcome": "filled"}]})");
  const Json holes = PageHoles(report, 10);
  EXPECT_EQ(holes[0]["taken_for"], "level ground");
  EXPECT_EQ(holes[0]["rim_level"], 3.5);
  EXPECT_FALSE(holes[1].contains("taken_for"));
}

TEST(PageHolesTest, HaveTheirCrossingsAndTheirCluster) {
  const Json report = Json::parse(R"({"per_hole": [
      {"id": 0, "area_m2": 9, "outcome": "filled", "cluster": 4, "crossings": 3},
      {"id": 1, "area_m2": 5, "outcome": "filled"}]})");
  const Json holes = PageHoles(report, 10);
  EXPECT_EQ(holes[0]["crossings"], 3);
  EXPECT_EQ(holes[0]["cluster"], 4);
  EXPECT_TRUE(holes[1]["crossings"].is_null());
  EXPECT_TRUE(holes[1]["cluster"].is_null());
}

TEST(PageHolesTest, OfWhatIsNoReportThereIsNone) {
  EXPECT_EQ(PageHoles(Json(), 10), Json::array());
  EXPECT_EQ(PageHoles(Json{{"per_hole", 3}}, 10), Json::array());
  EXPECT_EQ(PageHoles(Json{{"per_hole", {3}}}, 10)[0]["filled"], false);
}

}  // namespace
}  // namespace tilemend
