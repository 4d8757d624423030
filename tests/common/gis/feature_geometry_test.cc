// What becomes of geometries (feature_geometry.h), through the process that the programs start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string kSquare = PolygonText(SquareAt(0, 0, 4));  // NOLINT(cert-err58-cpp)

std::string PolygonOf(const std::string& ring) { return R"({"type": "Polygon", "coordinates": [)" + ring + "]}"; }

TEST(FeatureGeometryTest, AMultiPolygonIsOneArea) {
  const auto file = ParseWaterFile(
      {FeatureText(R"({"type": "MultiPolygon", "coordinates": [[[[0, 0, 9], [1, 0, 9], [1, 1, 9], [0, 0, 9]]],
                      [[[5, 5], [6, 5], [6, 6], [5, 5]], [[5.5, 5.1], [5.7, 5.1], [5.7, 5.2], [5.5, 5.1]]]]})")},
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_THAT(file->areas[0].polygon.rings, SizeIs(3));
}

TEST(FeatureGeometryTest, AnAreaThatCrossesItselfIsRefusedWithThePlace) {
  const std::string bow_tie = PolygonText({{0, 0}, {8, 8}, {8, 0}, {0, 8}});
  for (const std::string& text : {bow_tie, CollectionText({FeatureText(kSquare), FeatureText(bow_tie)})}) {
    const absl::Status status = ParseAreaFile({text}, "f", {}).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("ring 0 crosses itself at (4, 4)"));
  }
  EXPECT_TRUE(
      ParseAreaFile({CollectionText({FeatureText(kSquare), FeatureText(PolygonText(SquareAt(2, 2, 4)))})}, "f", {})
          .ok())
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

TEST(FeatureGeometryTest, WaterThatIsNotValidIsRepairedAndSaysWhere) {
  const std::string hole_beyond = "[[0,0],[8,0],[8,8],[0,8],[0,0]],[[6,2],[12,2],[12,6],[6,6],[6,2]]";
  const InvalidCase cases[] = {
      {PolygonText({{0, 0}, {8, 8}, {8, 0}, {0, 8}}), "ring 0 crosses itself at (4, 4)", {{1, 4}, {7, 4}}, {{4, 1}}},
      {PartsOf({SquareAt(0, 0, 4), SquareAt(2, 2, 4)}), "ring 0 crosses ring 1", {{1, 1}, {3, 3}, {5, 5}}, {{5, 1}}},
      {PartsOf({SquareAt(0, 0, 8), SquareAt(2, 2, 4)}), "Nested shells", {{1, 1}, {4, 4}}, {{9, 4}}},
      {PolygonOf(hole_beyond), "ring 0 crosses ring 1", {{1, 1}}, {{7, 4}, {10, 4}}}};
  for (const InvalidCase& invalid : cases) {
    const auto file = ParseWaterFile(
        {CollectionText({FeatureText(kSquare), FeatureText(invalid.geometry, R"({"name": "Pond"})")})}, "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_THAT(file->areas, SizeIs(2));
    for (const Point2& p : invalid.inside) EXPECT_TRUE(Contains(file->areas[1].polygon, p)) << invalid.geometry << p;
    for (const Point2& p : invalid.outside) EXPECT_FALSE(Contains(file->areas[1].polygon, p)) << invalid.geometry << p;
    ASSERT_THAT(file->warnings, SizeIs(1)) << invalid.geometry;
    EXPECT_THAT(file->warnings[0], StartsWith("f: feature 1 (Pond): "));
    EXPECT_THAT(file->warnings[0], HasSubstr(invalid.warning));
  }
}

TEST(FeatureGeometryTest, WhatSurroundsNothingIsRefused) {
  const absl::Status status = ParseWaterFile({PolygonText({{0, 0}, {4, 4}, {2, 2}})}, "f", {}).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("feature 0: "));
  EXPECT_THAT(std::string(status.message()), HasSubstr("surrounds nothing"));
}

TEST(FeatureGeometryTest, PartsOfAnAreaThatLieInEachOtherAreUnitedWithAWarning) {
  const auto file = ParseAreaFile({PartsOf({SquareAt(0, 0, 8), SquareAt(2, 2, 4)})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(Contains(file->area, {4, 4}));
  ASSERT_THAT(file->warnings, SizeIs(1));
  EXPECT_THAT(file->warnings[0], HasSubstr("feature 0: Nested shells"));
}

}  // namespace
}  // namespace tilemend
