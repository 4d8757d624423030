#include "client/holes_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json Hole(int id, double area) {
  return {{"id", id},        {"cell", {0, 1}},  {"kind", "closed"}, {"centre", {1.5, 2.5}},
          {"area_m2", area}, {"perimeter_m", 8}};
}

TEST(PlannedHolesTextTest, ListsWhatIsToBeFilledTheLargestFirstAndDoesNotPromiseIt) {
  Json plan;
  plan["per_hole"] = {Hole(0, 0.02), Hole(1, 30), Hole(2, 100)};
  plan["per_hole"][1]["level_m"] = 12.5;
  plan["per_hole"][2]["reason"] = "too wild";
  plan["per_hole"].push_back(Hole(3, 20));
  plan["per_hole"][3]["water"] = {{"taken_for", "ground"}, {"reason", "it falls"}};
  plan["per_hole"].push_back(Hole(4, 10));
  plan["per_hole"][4]["level_m"] = 3;
  plan["per_hole"][4]["water"] = {{"taken_for", "lake"}, {"level_m", 3}, {"sigma_m", 0.02}, {"reason", "it agrees"}};
  EXPECT_EQ(PlannedHolesText(plan),
            "\n4 holes to fill, the largest first; filling may find some that stay open\n"
            "hole  kind    cell   centre, m    area, m2  rim, m  taken for                       because\n"
            "   1  closed  [0,1]  [1.50,2.50]      30.0     8.0  at 12.500 m\n"
            "   3  closed  [0,1]  [1.50,2.50]      20.0     8.0  ground                          it falls\n"
            "   4  closed  [0,1]  [1.50,2.50]      10.0     8.0  lake at 3.000 m, sigma 0.020 m  it agrees\n"
            "   0  closed  [0,1]  [1.50,2.50]     < 0.1     8.0\n");
}

TEST(PlannedHolesTextTest, ShowsTheFirstOfMany) {
  Json plan;
  for (int k = 0; k < 40; ++k) plan["per_hole"].push_back(Hole(k, k));
  EXPECT_THAT(PlannedHolesText(plan), HasSubstr("and 10 more; -o json lists all\n"));
}

TEST(PlannedHolesTextTest, IsEmptyWithoutHoles) { EXPECT_EQ(PlannedHolesText(Json::object()), ""); }

TEST(LargeHolesTextTest, SaysWhatTheyWereFilledAsAndWhy) {
  Json report;
  report["per_hole"] = {Hole(0, 200), Hole(1, 300), Hole(2, 5)};
  for (Json& hole : report["per_hole"]) hole["outcome"] = "filled";
  report["per_hole"][0]["water"] = {{"taken_for", "ground"}, {"reason", "it falls"}};
  report["per_hole"][1]["level_m"] = 3;
  report["per_hole"][1]["water"] = {{"taken_for", "lake"}, {"level_m", 3}, {"reason", "a polygon says so"}};
  EXPECT_EQ(LargeHolesText(report),
            "\n2 large holes or parts of large holes\n"
            "hole  cell   centre, m    area, m2  filled as        because\n"
            "   1  [0,1]  [1.50,2.50]     300.0  lake at 3.000 m  a polygon says so\n"
            "   0  [0,1]  [1.50,2.50]     200.0  ground           it falls\n");
  report["per_hole"][1]["outcome"] = "left";
  EXPECT_THAT(LargeHolesText(report), HasSubstr("1 large hole or part of a large hole\n"));
}

TEST(LookAtTextTest, ListsPlaces) {
  Json report;
  EXPECT_EQ(LookAtText(report), "");
  report["look_at"] = Json::array();
  EXPECT_EQ(LookAtText(report), "");
  report["look_at"].push_back(
      {{"hole", 7}, {"cell", {0, 1}}, {"centre", {1.5, 2.5}}, {"area_m2", 300}, {"why", "it is large"}});
  EXPECT_EQ(LookAtText(report),
            "\n1 place to look at\n"
            "hole  cell   centre, m    area, m2  why\n"
            "   7  [0,1]  [1.50,2.50]     300.0  it is large\n");
}

TEST(ReviewTextTest, CountsTheFillsOfTheReportAndLooksAtNoneTwice) {
  Json report;
  EXPECT_EQ(ReviewText(report), "");
  report["look_at"] = Json::parse(R"([{"hole": 7, "why": "it is large"}, {"hole": 9, "area_m2": 4, "why": "no rim"}])");
  report["review"] = Json::parse(R"([
      {"hole": 7, "holes": [7, 8], "cell": [0, 1], "centre": [1.5, 2.5], "area_m2": 300, "taken_for": "lake",
       "doubt_m3": 9.25, "crossings": 3},
      {"hole": 5, "holes": [5], "cell": [0, 2], "centre": [4, 5], "area_m2": 120, "taken_for": "ground", "doubt_m3": 2,
       "reason": "its rim is too short"}])");
  EXPECT_EQ(ReviewText(report),
            "\n2 fills to decide on\n"
            "hole          cell   centre, m    area, m2  taken for  doubt, m3  crossings  because\n"
            "7 and 1 more  [0,1]  [1.50,2.50]     300.0  lake             9.2          3  it is large\n"
            "5             [0,2]  [4.00,5.00]     120.0  ground           2.0             its rim is too short\n");
  EXPECT_THAT(LookAtText(report), HasSubstr("\n1 place to look at\n"));
  EXPECT_THAT(LookAtText(report), HasSubstr("no rim"));
}

TEST(ReviewTextTest, SaysEachReasonOnceAsThePageDoes) {
  Json report;
  report["look_at"] = Json::parse(R"([{"hole": 1, "why": "it is large"}])");
  report["review"] = Json::parse(R"([
      {"hole": 1, "taken_for": "ground", "reason": "its rim is too short: 13 places tell its level, 20 are needed"},
      {"hole": 2, "taken_for": "ground", "reason": "its rim is too short: 11 places tell its level, 20 are needed"}])");
  EXPECT_EQ(ReviewText(report),
            "\n2 fills to decide on\n"
            "hole  cell  centre, m  area, m2  taken for  doubt, m3  because\n"
            "   1                   -         ground                "
            "[1] its rim is too short: 13 places tell its level, 20 are needed; it is large\n"
            "   2                   -         ground                [1] 11 places tell its level\n");
}

TEST(ReviewTextTest, RowsOfOneClusterBelongTogetherWhicheverHoleNamesThem) {
  Json report;
  report["review"] = Json::parse(R"([{"hole": 7, "holes": [7, 8], "area_m2": 300, "doubt_m3": 9.25}])");
  report["look_at"] = Json::parse(R"([{"hole": 8, "holes": [7, 8], "area_m2": 300, "why": "it is large"}])");
  EXPECT_THAT(ReviewText(report), HasSubstr("9.2  it is large\n"));
  EXPECT_EQ(LookAtText(report), "");
}

TEST(ReviewTextTest, ASmallDoubtIsNotZero) {
  Json report;
  report["review"] = Json::parse(R"([{"hole": 7, "doubt_m3": 0.04}, {"hole": 8, "doubt_m3": 0}, {"hole": 9}])");
  EXPECT_THAT(ReviewText(report), HasSubstr("< 0.1\n"));
  EXPECT_THAT(ReviewText(report), HasSubstr("  0.0\n"));
}

TEST(LookAtTextTest, SaysOfHowManyHolesTheAreaIs) {
  Json report;
  report["look_at"].push_back({{"hole", 7},
                               {"holes", {3, 5, 7, 9}},
                               {"cell", {0, 1}},
                               {"centre", {1.5, 2.5}},
                               {"area_m2", 14521.3},
                               {"why", "it is large"}});
  EXPECT_THAT(LookAtText(report), HasSubstr("7 and 3 more  [0,1]  [1.50,2.50]   14521.3  it is large\n"));
  report["look_at"][0]["holes"] = {7};
  EXPECT_THAT(LookAtText(report), HasSubstr("   7  [0,1]  [1.50,2.50]   14521.3  it is large\n"));
}

TEST(KindsTextTest, CountsTheCellsThatWereChosen) {
  Json report;
  report["per_hole"] = {Hole(0, 2), Hole(1, 3)};
  report["per_hole"][1]["outcome"] = "left";
  report["per_hole"][1]["reason"] = "in a cell that was not chosen";
  EXPECT_THAT(KindsText(report), HasSubstr("all               1  "));
}

TEST(KindsTextTest, AreasOfAColumnHaveOneForm) {
  Json report;
  report["per_hole"] = {Hole(0, 0.00001), Hole(1, 30), Hole(2, 0.03)};
  for (Json& hole : report["per_hole"]) hole["outcome"] = "filled";
  report["per_hole"][1]["kind"] = "I";
  report["per_hole"][2]["kind"] = "II";
  report["per_hole"][2]["outcome"] = "left";
  EXPECT_THAT(KindsText(report), HasSubstr("closed            1       1            < 0.1\n"));
  EXPECT_THAT(KindsText(report), HasSubstr("I                 1       1             30.0\n"));
  EXPECT_THAT(KindsText(report), HasSubstr("II                1       0              0.0\n"));
}

TEST(KindsTextTest, HasALegendOnlyWhereThereAreOpenHoles) {
  Json report;
  report["per_hole"] = {Hole(0, 2)};
  EXPECT_EQ(KindsText(report).find("closed:"), std::string::npos);
}

}  // namespace
}  // namespace tilemend
