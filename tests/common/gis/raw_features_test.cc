// What ReadVectors makes of geometries and properties (raw_features.h), through the module as the programs load it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

const std::string kSquare = PolygonText(SquareAt(0, 0, 4));  // NOLINT(cert-err58-cpp)

std::string PolygonOf(const std::string& ring) { return R"({"type": "Polygon", "coordinates": [)" + ring + "]}"; }

TEST(RawFeaturesTest, ABarePolygonIsWater) {
  const auto file = ParseWaterFile(kSquare, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_TRUE(file->areas[0].water);
  EXPECT_EQ(file->areas[0].level, std::nullopt);
  ASSERT_THAT(file->areas[0].polygon.rings, SizeIs(1));
  ASSERT_THAT(file->areas[0].polygon.rings[0], SizeIs(4)) << "the closing position is not repeated";
  EXPECT_EQ(file->areas[0].polygon.rings[0][2], Point2(4, 4));
}

TEST(RawFeaturesTest, FeaturesKeepTheirOrderAndSayWhatTheyAre) {
  const auto file =
      ParseWaterFile(CollectionText({FeatureText(kSquare, R"({"water": false})"), FeatureText(kSquare, "null"),
                                     FeatureText(kSquare, R"({"name": "Pond", "water": null, "level_m": null})"),
                                     FeatureText(kSquare, R"({"water": true, "level_m": -3, "depth": [1, 2]})")}),
                     "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(4));
  EXPECT_FALSE(file->areas[0].water);
  for (const int i : {1, 2, 3}) EXPECT_TRUE(file->areas[i].water) << i;
  EXPECT_EQ(file->areas[2].level, std::nullopt);
  EXPECT_EQ(file->areas[2].label, "feature 2 (Pond)");
  EXPECT_EQ(file->areas[3].level, -3);
}

TEST(RawFeaturesTest, PropertiesThatAreNearKnownOnesAreTold) {
  const std::string line = FeatureText(LineText({{1, 1}, {3, 3}}), R"({"elevation": 5})");
  const auto file = ParseWaterFile(
      CollectionText(
          {FeatureText(kSquare, R"({"layer": "lakes", "Water": true})"), FeatureText(kSquare, R"({"watr": false})"),
           FeatureText(kSquare, R"({"name": "Pond", "level": 11.5})"), FeatureText(kSquare, R"({"level": 3})"),
           FeatureText(kSquare, R"({"level": 3, "level_m": 4})"), line}),
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings,
              UnorderedElementsAre(
                  "f: feature 1: property 'watr' has no effect; the name that has is 'water'",
                  "f: feature 2 (Pond) and 1 more: property 'level' has no effect; the name that has is 'level_m'"));
}

TEST(RawFeaturesTest, LongNamesAreCut) {
  const std::string name(1000000, 'n');
  const auto file = ParseWaterFile(FeatureText(kSquare, absl::StrCat(R"({"name": "\u001b)", name, "\"}")), "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas[0].label, StartsWith("feature 0 (\\x1bnnn"));
  EXPECT_LT(file->areas[0].label.size(), 120U);
  const absl::Status status = ParseWaterFile(CollectionText({FeatureText(kSquare)}, name), "f", {}).status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("a CRS that is not known: 'nnn"));
  EXPECT_LT(status.message().size(), 300U);
}

TEST(RawFeaturesTest, AMultiPolygonIsOneArea) {
  const auto file = ParseWaterFile(
      FeatureText(R"({"type": "MultiPolygon", "coordinates": [[[[0, 0, 9], [1, 0, 9], [1, 1, 9], [0, 0, 9]]],
                      [[[5, 5], [6, 5], [6, 6], [5, 5]], [[5.5, 5.1], [5.7, 5.1], [5.7, 5.2], [5.5, 5.1]]]]})"),
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_THAT(file->areas[0].polygon.rings, SizeIs(3));
}

TEST(RawFeaturesTest, ACentrelineIsALineItsCoordinatesOrWkt) {
  for (const char* line : {R"({"type": "LineString", "coordinates": [[1, 1], [3, 2.5, 7]]})", "[[1, 1], [3, 2.5]]",
                           "\"LINESTRING (1 1, 3 2.5)\"", "\"MULTILINESTRING ((1 1, 3 2.5))\""}) {
    const auto file = ParseWaterFile(FeatureText(kSquare, absl::StrCat(R"({"centreline": )", line, "}")), "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_THAT(file->areas[0].centreline, ElementsAre(Point2(1, 1), Point2(3, 2.5))) << line;
  }
}

struct BadCase {
  std::string text;
  std::string message;
};

TEST(RawFeaturesTest, ErrorsNameTheFileAndThePlace) {
  const BadCase cases[] = {
      {R"({"type": "Point", "coordinates": [0, 0]})", "feature 0: POINT: expected Polygon, MultiPolygon or LineString"},
      {CollectionText({FeatureText(kSquare), kSquare}), "feature 1: no geometry"},
      {CollectionText({FeatureText("null")}), "feature 0: no geometry"},
      {CollectionText({FeatureText(kSquare), "7"}), "not all members"},
      {FeatureText(kSquare, R"({"water": "lake"})"), "feature 0: property water: expected true or false"},
      {FeatureText(kSquare, R"({"water": 2})"), "feature 0: property water: expected true or false"},
      {FeatureText(kSquare, R"({"level_m": "high"})"), "feature 0: property level_m: expected a height"},
      {FeatureText(kSquare, R"({"level_m": true})"), "feature 0: property level_m: expected a height"},
      {FeatureText(kSquare, R"({"level_m": 1e6})"), "feature 0: property level_m: expected a height"},
      {FeatureText(kSquare, R"({"centreline": "along"})"), "feature 0, property centreline: expected one LineString"},
      {FeatureText(kSquare, R"({"centreline": [[1, 1]]})"), "property centreline"},
      {FeatureText(LineText({{1, 1}})), "feature 0: expected a line of at least 2 positions"},
      {PolygonOf(""), "f: "},
      {PolygonOf("[]"), "feature 0, ring 0: expected a ring of at least 4 positions"},
      {PolygonOf("[[0, 0], [1, 0], [0, 0]]"), "feature 0, ring 0: expected a ring of at least 4 positions"},
      {PolygonOf("[[0, 0], [1, 0], [1, 1], [0, 1]]"), "feature 0, ring 0: the ring is not closed"},
      {PolygonOf("[[0, 0], [1], [1, 1], [0, 0]]"), "f: "},
      {PolygonOf("[[0, 0], [1, null], [1, 1], [0, 0]]"), "f: "},
      {PolygonOf("[[0, 0], [1, \"2\"], [1, 1], [0, 0]]"), "f: "},
      {R"({"type": "MultiPolygon", "coordinates": []})", "feature 0: a MultiPolygon without polygons"}};
  for (const BadCase& bad : cases) {
    const absl::Status status = ParseWaterFile(bad.text, "f", {}).status();
    ASSERT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << bad.text;
    EXPECT_THAT(std::string(status.message()), StartsWith("f: ")) << bad.text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(bad.message)) << bad.text;
  }
}

TEST(RawFeaturesTest, AnAreaThatCrossesItselfIsRefusedWithThePlace) {
  const std::string bow_tie = PolygonText({{0, 0}, {8, 8}, {8, 0}, {0, 8}});
  for (const std::string& text : {bow_tie, CollectionText({FeatureText(kSquare), FeatureText(bow_tie)})}) {
    const absl::Status status = ParseAreaFile(text, "f", {}).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("ring 0 crosses itself at (4, 4)"));
  }
  EXPECT_TRUE(
      ParseAreaFile(CollectionText({FeatureText(kSquare), FeatureText(PolygonText(SquareAt(2, 2, 4)))}), "f", {}).ok())
      << "features may overlap";
}

struct InvalidCase {
  std::string geometry;
  std::string warning;
  std::vector<Point2> inside, outside;
};

// Of a MultiPolygon, the rings of its parts.
std::string PartsOf(const std::vector<std::vector<Point2>>& outlines) {
  std::string parts;
  for (std::vector<Point2> ring : outlines) {
    ring.push_back(ring.front());
    absl::StrAppend(&parts, parts.empty() ? "" : ",", "[", PositionsText(ring), "]");
  }
  return absl::StrCat(R"({"type":"MultiPolygon","coordinates":[)", parts, "]}");
}

TEST(RawFeaturesTest, WaterThatIsNotValidIsRepairedAndSaysWhere) {
  const std::string hole_beyond = "[[0,0],[8,0],[8,8],[0,8],[0,0]],[[6,2],[12,2],[12,6],[6,6],[6,2]]";
  const InvalidCase cases[] = {
      {PolygonText({{0, 0}, {8, 8}, {8, 0}, {0, 8}}), "ring 0 crosses itself at (4, 4)", {{1, 4}, {7, 4}}, {{4, 1}}},
      {PartsOf({SquareAt(0, 0, 4), SquareAt(2, 2, 4)}), "ring 0 crosses ring 1", {{1, 1}, {3, 3}, {5, 5}}, {{5, 1}}},
      {PartsOf({SquareAt(0, 0, 8), SquareAt(2, 2, 4)}), "Nested shells", {{1, 1}, {4, 4}}, {{9, 4}}},
      {PolygonOf(hole_beyond), "ring 0 crosses ring 1", {{1, 1}}, {{7, 4}, {10, 4}}}};
  for (const InvalidCase& invalid : cases) {
    const auto file = ParseWaterFile(
        CollectionText({FeatureText(kSquare), FeatureText(invalid.geometry, R"({"name": "Pond"})")}), "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_THAT(file->areas, SizeIs(2));
    for (const Point2& p : invalid.inside) EXPECT_TRUE(Contains(file->areas[1].polygon, p)) << invalid.geometry << p;
    for (const Point2& p : invalid.outside) EXPECT_FALSE(Contains(file->areas[1].polygon, p)) << invalid.geometry << p;
    ASSERT_THAT(file->warnings, SizeIs(1)) << invalid.geometry;
    EXPECT_THAT(file->warnings[0], StartsWith("f: feature 1 (Pond): "));
    EXPECT_THAT(file->warnings[0], HasSubstr(invalid.warning));
  }
}

TEST(RawFeaturesTest, WhatSurroundsNothingIsRefused) {
  const absl::Status status = ParseWaterFile(PolygonText({{0, 0}, {4, 4}, {2, 2}}), "f", {}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("feature 0: "));
  EXPECT_THAT(std::string(status.message()), HasSubstr("surrounds nothing"));
}

TEST(RawFeaturesTest, PartsOfAnAreaThatLieInEachOtherAreUnitedWithAWarning) {
  const auto file = ParseAreaFile(PartsOf({SquareAt(0, 0, 8), SquareAt(2, 2, 4)}), "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(Contains(file->area, {4, 4}));
  ASSERT_THAT(file->warnings, SizeIs(1));
  EXPECT_THAT(file->warnings[0], HasSubstr("feature 0: Nested shells"));
}

}  // namespace
}  // namespace tilemend
