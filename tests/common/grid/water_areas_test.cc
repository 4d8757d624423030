#include "common/grid/water_areas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr char kSquare[] = R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]})";

std::string Feature(const std::string& geometry, const std::string& properties) {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": )" + geometry + "}";
}

std::string Collection(const std::string& features) {
  return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

std::string PolygonOf(const std::string& ring) { return R"({"type": "Polygon", "coordinates": [)" + ring + "]}"; }

TEST(ParseWaterAreasTest, ABarePolygonIsWater) {
  const auto areas = ParseWaterAreas(kSquare, "f");
  ASSERT_TRUE(areas.ok()) << areas.status();
  ASSERT_THAT(*areas, SizeIs(1));
  EXPECT_TRUE((*areas)[0].water);
  ASSERT_THAT((*areas)[0].polygon.rings, SizeIs(1));
  ASSERT_THAT((*areas)[0].polygon.rings[0], SizeIs(4)) << "the closing position is not repeated";
  EXPECT_EQ((*areas)[0].polygon.rings[0][2], Point2(4, 4));
}

TEST(ParseWaterAreasTest, FeaturesKeepTheirOrderAndSayWhatTheyAre) {
  const std::string text =
      Collection(Feature(kSquare, R"({"water": false})") + "," + Feature(kSquare, "null") + "," +
                 Feature(kSquare, R"({"name": "Pond", "water": null})") + "," + Feature(kSquare, R"({"water": true})"));
  const auto areas = ParseWaterAreas(text, "f");
  ASSERT_TRUE(areas.ok()) << areas.status();
  ASSERT_THAT(*areas, SizeIs(4));
  EXPECT_FALSE((*areas)[0].water);
  for (const int i : {1, 2, 3}) EXPECT_TRUE((*areas)[i].water) << i;
}

TEST(ParseWaterAreasTest, AMultiPolygonIsOneArea) {
  const auto areas = ParseWaterAreas(
      Feature(R"({"type": "MultiPolygon", "coordinates": [[[[0, 0, 9], [1, 0, 9], [1, 1, 9], [0, 0, 9]]],
                 [[[5, 5], [6, 5], [6, 6], [5, 5]], [[5.1, 5.1], [5.2, 5.1], [5.2, 5.2], [5.1, 5.1]]]]})",
              "{}"),
      "f");
  ASSERT_TRUE(areas.ok()) << areas.status();
  ASSERT_THAT(*areas, SizeIs(1));
  EXPECT_THAT((*areas)[0].polygon.rings, SizeIs(3));
}

TEST(ParseWaterAreasTest, AnEmptyCollectionHasNone) {
  const auto areas = ParseWaterAreas(Collection(""), "f");
  ASSERT_TRUE(areas.ok()) << areas.status();
  EXPECT_TRUE(areas->empty());
}

struct BadCase {
  std::string text;
  std::string message;
};

TEST(ParseWaterAreasTest, ErrorsNameTheFileAndThePlace) {
  const std::string line = R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})";
  const BadCase cases[] = {
      {"", "not JSON: byte 1"},
      {"{\n \"type\": \"Polygon\",\n \"coordinates\": [}", "line 3, column 18"},
      {"[1]", "GeoJSON: expected an object"},
      {"{}", "GeoJSON: \"type\" is missing"},
      {R"({"type": 7})", "GeoJSON.type: expected a text"},
      {line, "GeoJSON: type \"LineString\": expected Polygon or MultiPolygon"},
      {R"({"type": "FeatureCollection"})", "GeoJSON: \"features\" is missing"},
      {R"({"type": "FeatureCollection", "features": {}})", "GeoJSON.features: expected an array"},
      {Collection(Feature(kSquare, "{}") + "," + kSquare), "GeoJSON.features[1]: type \"Polygon\": expected Feature"},
      {Collection(Feature("null", "{}")), "GeoJSON.features[0].geometry: expected an object"},
      {Collection(Feature(line, "{}")), "GeoJSON.features[0].geometry: type \"LineString\""},
      {Collection(Feature(kSquare, R"({"water": "lake"})")), "features[0].properties.water: expected true or false"},
      {PolygonOf(""), "GeoJSON.coordinates: expected an array of rings"},
      {PolygonOf("[[0, 0], [1, 0], [0, 0]]"), "GeoJSON.coordinates[0]: expected a ring of at least 4 positions"},
      {PolygonOf("[[0, 0], [1, 0], [1, 1], [0, 1]]"), "GeoJSON.coordinates[0]: the ring is not closed"},
      {PolygonOf("[[0, 0], [1], [1, 1], [0, 0]]"), "GeoJSON.coordinates[0][1]: expected [x, y]"},
      {PolygonOf("[[0, 0], [1, null], [1, 1], [0, 0]]"), "GeoJSON.coordinates[0][1]: expected [x, y]"},
      {PolygonOf("[[0, 0], [1, 0], [1e10, 1], [0, 0]]"), "GeoJSON.coordinates[0][2]: must be at most 1e9 m"}};
  for (const BadCase& bad : cases) {
    const auto areas = ParseWaterAreas(bad.text, "lakes.geojson");
    ASSERT_EQ(areas.status().code(), absl::StatusCode::kInvalidArgument) << bad.text;
    EXPECT_THAT(std::string(areas.status().message()), StartsWith("lakes.geojson: ")) << bad.text;
    EXPECT_THAT(std::string(areas.status().message()), HasSubstr(bad.message)) << bad.text;
  }
}

}  // namespace
}  // namespace tilemend
