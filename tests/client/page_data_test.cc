#include "client/page_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/csv.h"
#include "client/report_page.h"
#include "client/reported_output.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Json = nlohmann::ordered_json;

constexpr char kReport[] = R"({"cells": 3, "scene": "/data/<b>x</b>", "options": {"textures": "off"}, "per_hole": [
  {"id": 0, "cell": [0, 0], "kind": "I", "type": "B", "centre": [1, 2], "area_m2": 5.5, "perimeter_m": 9,
   "outcome": "filled", "method": "water", "level_m": [3.5, 3.25], "crossings": 4, "water": {"sigma_m": 0.02, "reason": "level"}},
  {"id": 1, "cell": [1, 0], "kind": "closed", "single": "crack", "centre": [11, 2], "area_m2": -70, "perimeter_m": 12,
   "outcome": "left", "rim_height_m": 3.5, "reason": "=cmd, \"quoted\" </script><script>alert(1)</script>"}],
  "left": [{"cell": [1, 0], "hole": 1, "reason": "r"}, {"cell": [2, 0], "at": [21, 3, 7], "open_edges": 4, "reason": "loose"}],
  "cleared": {"tiles": [{"cell": [0, 0], "triangles": 17}]},
  "borders": {"inexact": [{"margins_m": [0.1, 0.25]}]}})";

Json Report() { return Json::parse(kReport); }

TEST(PageDataTest, LeftHolesComeFirstAndCellsAreCounted) {
  const Json data = PageData(Report(), nullptr, {});
  ASSERT_THAT(data["per_hole"], SizeIs(2));
  EXPECT_EQ(data["per_hole"][0]["id"], 1);
  EXPECT_EQ(data["per_hole"][0]["area"], 70);
  EXPECT_EQ(data["per_hole"][1]["kind"], "I B");
  EXPECT_EQ(data["cells"], Json::parse("[[0, 0, 1, 0, 1, 0], [1, 0, 0, 1, 1, 1], [2, 0, 0, 1, 1, 1]]"));
}

TEST(PageDataTest, TheVerdictIsThatOfTheExitCode) {
  Json report = Report();
  EXPECT_EQ(PageData(report, nullptr, {})["verdict"],
            Json::parse(R"({"filled": 1, "left": 2, "counting": 2, "uncounted": "", "chosen": ""})"));
  report["left"].erase(1);
  report["per_hole"][1]["area_m2"] = 0;
  const Json tiny = PageData(report, nullptr, {});
  EXPECT_EQ(tiny["verdict"]["left"], 1);
  EXPECT_EQ(tiny["verdict"]["counting"], 0);
  EXPECT_THAT(tiny["verdict"]["uncounted"].get<std::string>(), HasSubstr("is smaller than 0.05 m2"));
  EXPECT_EQ(tiny["cells"][1], Json::parse("[1, 0, 0, 1, 1, 0]"));
}

TEST(PageDataTest, HolesOfCellsThatWereNotChosenAreNeitherFilledNorLeft) {
  Json report = Report();
  report["options"]["cells"] = "0,0";
  report["left"] = Json::array();
  report["per_hole"][1]["outcome"] = "not chosen";
  report["per_hole"][1]["reason"] = "in a cell that was not chosen";
  Scene scene;
  scene.tiles = {{{0, 0}, "a.obj"}, {{1, 0}, "b.obj"}, {{2, 0}, "c.obj"}};
  const Json data = PageData(report, &scene, {});
  EXPECT_EQ(
      data["verdict"],
      Json::parse(R"({"filled": 1, "left": 0, "counting": 0, "uncounted": "", "chosen": "1 of 3 cells was chosen"})"));
  EXPECT_EQ(data["cells"], Json::parse("[[0, 0, 1, 0, 1, 0]]"));
  EXPECT_EQ(data["hole_count"], 1);
  EXPECT_THAT(data["per_hole"], SizeIs(1));
  EXPECT_EQ(PageData(report, nullptr, {})["verdict"]["chosen"], "");
  EXPECT_THAT(HolesCsv(report), HasSubstr(",12,not chosen,"));
  EXPECT_THAT(ReadReported(report).left, SizeIs(1)) << "its boundary stays as it is";
}

TEST(PageDataTest, CellsOfTheSceneWithoutAHoleAreThere) {
  Scene scene;
  scene.tiles = {{{0, 0}, "a.obj"}, {{7, 2}, ""}};
  const Json cells = PageData(Report(), &scene, {})["cells"];
  EXPECT_EQ(cells.back(), Json::parse("[7, 2, 0, 0, 0, 0]"));
}

TEST(PageDataTest, AReportOfAnotherFormGivesAnEmptyPage) {
  const Json data = PageData(Json::parse(R"({"per_hole": 7, "left": "x", "cells": 1})"), nullptr, {});
  EXPECT_THAT(data["per_hole"], SizeIs(0));
  EXPECT_THAT(ReportPage(data), StartsWith("<!doctype html>"));
}

TEST(PageDataTest, OptionsThatAreTheDefaultsAreNotRepeated) {
  const Json report = Json::parse(
      R"({"options": {"textures": "off", "gradation": 1.3, "uniform": false, "area": "", "cells": "1,1"}})");
  EXPECT_EQ(PageData(report, nullptr, {})["changed_options"], Json({{"textures", "off"}, {"cells", "1,1"}}));
}

TEST(ReportPageTest, NoTextEndsTheElementItIsIn) {
  const std::string page = ReportPage(PageData(Report(), nullptr, {}));
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
  EXPECT_THAT(page, Not(HasSubstr("<b>x</b>")));
  EXPECT_THAT(page, HasSubstr("\\u003c/script\\u003e"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'sha256-"));
  size_t scripts = 0;
  for (size_t at = page.find("</script"); at != std::string::npos; at = page.find("</script", at + 1)) ++scripts;
  EXPECT_EQ(scripts, 2U);
}

TEST(HolesCsvTest, QuotesTextsAndDisarmsFormulas) {
  const std::string csv = HolesCsv(Report());
  EXPECT_THAT(csv, StartsWith("id,column,row,x,y,kind,"));
  EXPECT_THAT(csv, HasSubstr(",doubt_m3,crossings,decision,reason\r\n"));
  EXPECT_THAT(csv, HasSubstr("0,0,0,1,2,I,B,,5.5,9,filled,water,3.5 to 3.25,0.02,,,4,,level\r\n"));
  EXPECT_THAT(csv, HasSubstr("-70,12,left,,,,,,,,\"'=cmd, \"\"quoted\"\" "));
  EXPECT_EQ(CsvField("-3.5"), "-3.5");
  EXPECT_EQ(CsvField("@x"), "'@x");
}

TEST(ReportedOutputTest, ReadsWhatTheCheckAsksFor) {
  const ReportedOutput reported = ReadReported(Report());
  ASSERT_THAT(reported.left, SizeIs(2));
  EXPECT_EQ(reported.left[0].reach, 6);
  EXPECT_EQ(reported.left[0].at, Point3(11, 2, 3.5));
  EXPECT_EQ(reported.left[1].at, Point3(21, 3, 7));
  const auto& water = reported.water.at({0, 0});
  ASSERT_THAT(water, SizeIs(1));
  EXPECT_EQ(water[0].fill.lowest, 3.25);
  EXPECT_EQ(water[0].fill.highest, 3.5);
  EXPECT_EQ(reported.cleared.at({0, 0}), 17);
  EXPECT_EQ(reported.overlap, 0.25);
  EXPECT_FALSE(reported.has_textures);
  EXPECT_THAT(ReadReported(Json::parse(R"({"per_hole": [3], "left": 1, "borders": []})")).left, SizeIs(0));
}

}  // namespace
}  // namespace tilemend
