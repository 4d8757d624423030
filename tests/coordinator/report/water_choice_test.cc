#include "coordinator/report/water_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(WaterChoiceTest, FindsWaterOrDoesNot) {
  const auto find = ReadWaterChoice(kFindWater, {}), off = ReadWaterChoice(kNoWater, {});
  ASSERT_TRUE(find.ok() && off.ok());
  EXPECT_TRUE(find->options.find);
  EXPECT_FALSE(off->options.find);
  EXPECT_EQ(find->digest, "");
}

TEST(WaterChoiceTest, AFileGivesExceptionsAndCountsByItsContent) {
  const TemporaryFolder folder;
  const std::string text = R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]})";
  const auto choice = ReadWaterChoice(folder.Write("areas.geojson", text), {});
  ASSERT_TRUE(choice.ok()) << choice.status();
  EXPECT_TRUE(choice->options.find);
  EXPECT_EQ(choice->options.areas.size(), 1U);
  EXPECT_EQ(choice->digest, Sha256Hex(text));
}

TEST(WaterChoiceTest, AllOfASecondFileIsCleared) {
  const TemporaryFolder folder;
  const std::string ring = R"("geometry": {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}})";
  const std::string plain = R"({"type": "Feature", "properties": {}, )" + ring;
  WaterChoice choice = *ReadWaterChoice(folder.Write("a.geojson", plain), {});
  ASSERT_TRUE(AddClearFile("", {}, choice).ok());
  EXPECT_EQ(choice.options.areas.size(), 1U);
  ASSERT_TRUE(AddClearFile(folder.Write("b.geojson", plain), {}, choice).ok());
  ASSERT_EQ(choice.options.areas.size(), 2U);
  EXPECT_FALSE(choice.options.areas[0].clear);
  EXPECT_TRUE(choice.options.areas[1].clear);
  EXPECT_EQ(choice.clear_digest, Sha256Hex(plain));
  const std::string high = R"({"type": "Feature", "properties": {"clear_height": 4}, )" + ring;
  ASSERT_TRUE(AddClearFile(folder.Write("high.geojson", high), {}, choice).ok());
  EXPECT_EQ(choice.options.areas[2].clear_height, 4);
  EXPECT_THAT(choice.warnings, testing::IsEmpty()) << "the height has effect";
  const std::string river = R"({"type": "Feature", "properties": {"kind": "river"}, )" + ring;
  const absl::Status refused = AddClearFile(folder.Write("c.geojson", river), {}, choice);
  EXPECT_TRUE(absl::IsInvalidArgument(refused)) << refused;
  EXPECT_THAT(std::string(refused.message()), HasSubstr("kind is river, but clear"));
}

TEST(WaterChoiceTest, DecisionsComeLastAndCountByTheirContent) {
  const TemporaryFolder folder;
  const std::string ring = R"("geometry": {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]]]}})";
  WaterChoice choice =
      *ReadWaterChoice(folder.Write("a.geojson", R"({"type": "Feature", "properties": {}, )" + ring), {});
  ASSERT_TRUE(AddDecisions("", {}, choice).ok());
  EXPECT_EQ(choice.decisions_digest, "");
  const std::string text = R"({"type": "Feature", "properties": {"decision": "open"}, )" + ring;
  ASSERT_TRUE(AddDecisions(folder.Write("d.geojson", text), {}, choice).ok());
  ASSERT_EQ(choice.options.areas.size(), 2U);
  EXPECT_EQ(choice.options.areas[1].decision, ReviewDecision::kOpen);
  EXPECT_EQ(choice.decisions_digest, Sha256Hex(text));
  const absl::Status missing = AddDecisions(folder / "none.geojson", {}, choice);
  EXPECT_TRUE(absl::IsNotFound(missing)) << missing;
}

TEST(WaterChoiceTest, DecisionsOnAnotherSceneAreRefusedBeforeTheirCoordinates) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("d.geojson", R"({"type": "FeatureCollection",
      "tilemend_scene": {"name": "harbour", "crs": "EPSG:25832", "grid_corner": [0, 0], "cell_size": [0, 0]}, "features": 3})");
  Scene scene;
  scene.root = "/data/city";
  WaterChoice choice;
  EXPECT_THAT(std::string(AddDecisions(file, scene, choice).message()),
              HasSubstr("its decisions are on scene 'harbour'"));
}

TEST(WaterChoiceTest, ALevelFarFromAllSurfaceIsRefused) {
  SurveyRecord low, high, empty;
  low.lo = {0, 0, 80}, low.hi = {1, 1, 90};
  high.lo = {1, 0, 85}, high.hi = {2, 1, 120};
  empty.lo = {1, 0, 0}, empty.hi = {0, 0, 0};
  const std::map<CellId, StoredRecord> records = {{{0, 0}, &low}, {{1, 0}, &high}, {{2, 0}, &empty}, {{3, 0}, nullptr}};
  const auto check = [&](double level, bool water) {
    WaterArea area;
    area.water = water;
    area.level = level;
    area.label = "feature 7";
    return CheckLevels({{}, area}, records);
  };
  for (const double level : {-20.0, 100.0, 220.0}) EXPECT_TRUE(check(level, true).ok()) << level;
  EXPECT_TRUE(check(99999, false).ok());
  const absl::Status above = check(99999, true), below = check(-21, true);
  EXPECT_TRUE(absl::IsInvalidArgument(above)) << above;
  EXPECT_THAT(std::string(above.message()), HasSubstr("feature 7: its level_m is 99879.0 m above all surface"));
  EXPECT_THAT(std::string(below.message()), HasSubstr("feature 7: its level_m is 101.0 m below all surface"));
}

// What was taken out beyond the area would stay open.
TEST(WaterChoiceTest, WhatIsClearedHasToLieInTheArea) {
  const auto box = [](double lo, double hi) { return PlanePolygon{{{{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}}}}; };
  const auto choice_of = [&](const PlanePolygon& polygon, bool clear) {
    WaterChoice choice;
    WaterArea& area = choice.options.areas.emplace_back();
    area.polygon = polygon;
    area.label = "feature 7";
    area.clear = clear;
    return choice;
  };
  WaterChoice inside = choice_of(box(2, 4), true), across = choice_of(box(8, 12), true),
              around = choice_of(box(-5, 20), true), beyond = choice_of(box(20, 30), true),
              plain = choice_of(box(8, 12), false);
  EXPECT_TRUE(KeepClearInside(box(0, 10), inside).ok());
  EXPECT_EQ(inside.options.areas.size(), 1U);
  EXPECT_THAT(std::string(KeepClearInside(box(0, 10), across).message()), HasSubstr("feature 7: lies across the edge"));
  EXPECT_TRUE(absl::IsInvalidArgument(KeepClearInside(box(0, 10), around)));
  EXPECT_TRUE(KeepClearInside(box(0, 10), beyond).ok());
  EXPECT_TRUE(beyond.options.areas.empty());
  ASSERT_EQ(beyond.warnings.size(), 1U);
  EXPECT_THAT(beyond.warnings[0], HasSubstr("feature 7: lies outside the area"));
  EXPECT_TRUE(KeepClearInside(box(0, 10), plain).ok());
  WaterChoice touching = choice_of({{{{5, 5}, {10, 6}, {5, 7}}}}, true);
  EXPECT_TRUE(absl::IsInvalidArgument(KeepClearInside(box(0, 10), touching)));
  for (const bool outer_first : {false, true}) {  // parts of one feature, inside and outside
    PlanePolygon parts = box(2, 4);
    parts.rings.insert(outer_first ? parts.rings.begin() : parts.rings.end(), box(20, 30).rings[0]);
    WaterChoice both = choice_of(parts, true);
    EXPECT_TRUE(KeepClearInside(box(0, 10), both).ok());
    ASSERT_EQ(both.options.areas.size(), 1U);
    EXPECT_EQ(both.options.areas[0].polygon.rings, box(2, 4).rings);
    ASSERT_EQ(both.warnings.size(), 1U);
    EXPECT_THAT(both.warnings[0], HasSubstr("feature 7: a part of it lies outside the area"));
  }
  EXPECT_TRUE(KeepClearInside({}, across).ok());
}

// A ring of n points: a circle with a tooth at every other point.
PlanePolygon Teeth(int32_t n, double radius, double depth) {
  std::vector<Point2> ring;
  for (int32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = radius + (i % 2 == 0 ? depth : 0);
    ring.push_back(r * Point2(std::cos(angle), std::sin(angle)));
  }
  return {{ring}};
}

// To compare each point with each would take a minute.
TEST(WaterChoiceTest, LongRingsAreComparedWithALongArea) {
  constexpr int32_t kPoints = 50'000;
  const auto side = [&](double radius, double depth) {
    WaterChoice choice;
    WaterArea& water = choice.options.areas.emplace_back();
    water.polygon = Teeth(kPoints, radius, depth);
    water.clear = true;
    return KeepClearInside(Teeth(kPoints, 1000, 10), choice).ok();
  };
  EXPECT_TRUE(side(980, 10));
  EXPECT_FALSE(side(980, 40)) << "its teeth cross those of the area";
  EXPECT_FALSE(side(1005, 10)) << "it lies around the area";
}

TEST(WaterChoiceTest, NamesAFileThatCannotBeUsed) {
  const TemporaryFolder folder;
  const absl::Status missing = ReadWaterChoice(folder / "none.geojson", {}).status();
  EXPECT_TRUE(absl::IsNotFound(missing)) << missing;
  EXPECT_THAT(std::string(missing.message()), HasSubstr("none.geojson"));
  const absl::Status broken = ReadWaterChoice(folder.Write("broken.geojson", "{"), {}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(broken)) << broken;
  EXPECT_THAT(std::string(broken.message()), HasSubstr("broken.geojson"));
}

}  // namespace
}  // namespace tilemend
