#include "client/report_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "absl/strings/str_split.h"

namespace tilemend {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

const Json& Report() {
  static const Json kReport = Json::parse(R"({
    "version": "1.2.3", "date": "2026-11-22T05:10:00Z", "scene": "/data/city", "cells": 4, "clusters": 2,
    "options": {"surface": "wang", "uniform": false, "gradation": 1.5, "clear": ""},
    "warnings": ["mind the gap"],
    "water": [{"kind": "lake", "level_m": 1.23456, "rim_m": [1, 2], "area_m2": 40.04, "cells": 2, "decided_by": "rim"},
              {"kind": "river", "level_m": [5.5, 4.25], "area_m2": 900, "cells": 3,
               "removed_rises": [{"rise_m": 0.5}, {"rise_m": 0.25}]}],
    "borders": {"exact": 3, "near": 1, "open": 0,
                "inexact": [{"cells": [[0, 0], [1, 0]], "kind": "near", "offset_m": 0.25}]},
    "left": [{"cell": [3, 4], "reason": "no loop", "open_edges": 1},
             {"cell": [1, 2], "reason": "too wild", "hole": 7, "open_edges": 9}],
    "not_holes": [{"what": "outline of a piece", "count": 12, "open_edges": 345}],
    "levels": [{"level": 0, "nodes": 2, "filled": 1, "added": 40, "removed": 0},
               {"level": 1, "nodes": 8, "filled": 4, "added": 640, "removed": 25}],
    "tension": [{"hole": 7, "tension": 0.5, "hold_out_error_m": 0.1}],
    "quality": {"triangles": 5, "least": 0.123456, "poor": 0},
    "seconds": {"fill": 1.234567}, "peak_rss_bytes": 23456789,
    "per_hole": [{"id": 7, "cell": [1, 2], "kind": "closed", "centre": [1.5, 2.5], "area_m2": 33.25, "outcome": "left"},
                 {"id": 8, "cell": [1, 2], "kind": "I", "type": "B", "area_m2": 100.04, "outcome": "filled",
                  "method": "over the ground"},
                 {"id": 9, "cell": [2, 2], "kind": "I", "type": "B", "area_m2": 900, "outcome": "filled",
                  "method": "water"}]})");
  return kReport;
}

TEST(SummaryTextTest, BeginsWithTheWarnings) {
  EXPECT_TRUE(SummaryText(Report()).starts_with("\n1 warning\n  mind the gap\n\n")) << SummaryText(Report());
}

TEST(SummaryTextTest, TellsWhatWasFilledByKindAndByMethodWithItsArea) {
  const std::string text = SummaryText(Report());
  EXPECT_THAT(text, HasSubstr("kind of hole  found  filled  area filled, m2\n"
                              "closed            1       0              0.0\n"
                              "I B               2       2           1000.0\n"
                              "all               3       2           1000.0\n"
                              "closed: inside one cell."));
  EXPECT_THAT(text, HasSubstr("how filled       holes  area, m2\n"
                              "over the ground      1     100.0\n"
                              "water                1     900.0\n"));
}

TEST(SummaryTextTest, TellsWhatEachLevelOfDetailGot) {
  EXPECT_THAT(SummaryText(Report()), HasSubstr("\nlevel  nodes  filled  triangles added  removed\n"
                                               "    0      2       1               40        0\n"
                                               "    1      8       4              640       25\n"
                                               "level 0 is the coarsest.\n"));
}

TEST(SummaryTextTest, TellsEachBodyOfWaterWithItsLevelTheLargestFirst) {
  EXPECT_THAT(SummaryText(Report()), HasSubstr("\n2 filled flat as water\n"
                                               "water  level, m        area, m2  cells"));
  const std::string text = SummaryText(Report());
  EXPECT_LT(text.find("river  5.500 to 4.250     900.0"), text.find("lake   1.235"));
  EXPECT_THAT(text, HasSubstr("2, 0.500 m at most"));
}

TEST(SummaryTextTest, TellsWhatPolygonsTookOut) {
  const Json report = Json::parse(R"({"cleared": {"triangles": 477, "tiles": [], "areas": [
      {"feature": "canal", "water": true, "top_m": 2.4, "triangles": 473, "tiles": []},
      {"feature": "crane", "water": false, "triangles": 4, "tiles": []}]}})");
  const std::string text = SummaryText(report);
  EXPECT_THAT(text, HasSubstr("477 original triangles taken out"));
  EXPECT_THAT(text, ContainsRegex("canal +473 +2.40"));
  EXPECT_THAT(text, ContainsRegex("crane +4 +any"));
  EXPECT_EQ(SummaryText(Json::parse(R"({"cleared": {"triangles": 0, "tiles": [], "areas": []}})")), "");
}

TEST(SummaryTextTest, TellsPairsOfTilesThatAreApart) {
  EXPECT_THAT(SummaryText(Report()), HasSubstr("borders between tiles: 3 exact, 1 near\n"
                                               "1 pair of tiles more than 0.1 m apart, or fills more than 0.02 m\n"
                                               "cells        they meet  overlap, m  apart, m  90 %, m  fill, m  "
                                               "90 %, m  99 %, m\n"
                                               "[0,0] [1,0]  near                      0.250\n"
                                               "apart: of tiles that overlap"));
}

TEST(SummaryTextTest, CallsTilesThatOverlapApartByTheirHeights) {
  Json report = Report();
  report["borders"]["inexact"] = Json::parse(
      R"([{"cells": [[0, 0], [1, 0]], "kind": "overlap", "offset_m": 0.5},
          {"cells": [[1, 0], [2, 0]], "kind": "overlap", "offset_m": 0.5, "apart_m": {"median": 0.05}},
          {"cells": [[2, 0], [3, 0]], "kind": "overlap", "offset_m": 0.5, "apart_m": {"median": 0.1234, "ninth_decile": 1.5}}])");
  const std::string text = SummaryText(report);
  EXPECT_THAT(text, HasSubstr("1 pair of tiles more than 0.1 m apart, or fills"));
  EXPECT_THAT(text, HasSubstr("[2,0] [3,0]  overlap         0.500     0.123    1.500\n"));
}

TEST(SummaryTextTest, TellsHowFarFillsAreApart) {
  Json report = Report();
  report["borders"]["inexact"] = Json::parse(
      R"([{"cells": [[0, 0], [1, 0]], "kind": "overlap", "offset_m": 0.5,
           "fill_apart_m": {"median": 0.001, "ninth_decile": 0.004, "percentile_99": 0.015, "places": 9}},
          {"cells": [[1, 0], [2, 0]], "kind": "overlap", "offset_m": 0.5,
           "fill_apart_m": {"median": 0.002, "ninth_decile": 0.012, "percentile_99": 0.25, "places": 9}}])");
  const std::string text = SummaryText(report);
  EXPECT_THAT(text, HasSubstr("fills overlap at 2 borders: at most 0.250 m apart at 99 % of the places of each\n"
                              "these places lie along the whole border, where both tiles have a fill.\n"
                              "`tilemend check` measures only where one fill ends:\n"
                              "up or down from its edge to the other fill.\n"
                              "1 pair"));
  EXPECT_THAT(text, HasSubstr("[1,0] [2,0]  overlap         0.500     0.000             0.002    0.012    0.250\n"));
}

TEST(SummaryTextTest, ListsHolesThatAreLeftFirstAndCountsWhatIsNone) {
  EXPECT_THAT(SummaryText(Report()), HasSubstr("\n2 left\n"
                                               "hole  cell   centre, m    area, m2  edges  reason\n"
                                               "   7  [1,2]  [1.50,2.50]      33.2      9  too wild\n"
                                               "      [3,4]                      -      1  no loop\n"
                                               "\nopen, but no holes\n"
                                               "number  edges  what\n"
                                               "    12    345  outline of a piece\n"));
}

TEST(SummaryTextTest, IsShortHoweverMuchThereIs) {
  Json report = Report();
  for (int k = 0; k < 1000; ++k) {
    for (const char* list : {"warnings", "water", "left"}) report[list].push_back(report[list][0]);
    report["borders"]["inexact"].push_back(report["borders"]["inexact"][0]);
  }
  const std::string text = SummaryText(report);
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 180);
  EXPECT_THAT(text, HasSubstr("and 972 more; see `left` in the report\n"));
}

TEST(SummaryTextTest, NoLineOfATableIsLongerThanTheTerminal) {
  Json report = Report();
  report.erase("warnings");
  report["review"] = Json::parse(R"([{"hole": 3, "cell": [0, 1], "centre": [60, 160], "area_m2": 128, "doubt_m3": 60.5,
    "taken_for": "ground", "reason": "its rim is too short: 11 places tell its level, 20 are needed"}])");
  const std::string text = SummaryText(report, 80);
  for (const absl::string_view line : absl::StrSplit(text, '\n')) EXPECT_LE(line.size(), 80) << line;
  EXPECT_THAT(text, HasSubstr("\n      its rim is too short: 11 places tell its level, 20 are needed\n"));
  EXPECT_THAT(text, HasSubstr("\nwater  level, m"));
  EXPECT_THAT(SummaryText(report), HasSubstr("60.5  its rim is too short"));
}

TEST(SummaryTextTest, OfAnEmptyOrOldReportIsEmpty) {
  for (const char* json : {"{}", R"({"left": 3, "water": null, "per_hole": {}, "warnings": "none", "borders": []})"}) {
    EXPECT_EQ(SummaryText(Json::parse(json)), "") << json;
  }
}

TEST(ReportTextTest, SaysOfWhatWhenAndHow) {
  const std::string text = ReportText(Report());
  EXPECT_THAT(text, HasSubstr("scene     /data/city\n"
                              "made      2026-11-22T05:10:00Z by tilemend 1.2.3\n"
                              "options   surface wang, gradation 1.5\n"
                              "cells     4\n"));
}

TEST(ReportTextTest, TellsTheFiguresOfTheWorkInUnitsForPeople) {
  const std::string text = ReportText(Report());
  EXPECT_THAT(text, HasSubstr("\n1 tension chosen from the rim\n"));
  EXPECT_THAT(text, ContainsRegex("triangles filled +5\n"));
  EXPECT_THAT(text, ContainsRegex("worst +0.1235\n"));
  EXPECT_THAT(text, ContainsRegex("fill, s +1.235\n"));
  EXPECT_THAT(text, ContainsRegex("peak memory, MB +23\n"));
  EXPECT_THAT(text, Not(HasSubstr("poor")));
}

}  // namespace
}  // namespace tilemend
