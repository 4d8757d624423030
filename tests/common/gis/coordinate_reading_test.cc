// What ReadVectors takes coordinates for (coordinate_reading.h), through the process that the programs start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "absl/strings/str_replace.h"
#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kUtm[] = "urn:ogc:def:crs:EPSG::25832";

// A square kilometre in Munich.
SceneFrame Munich() { return {"EPSG:25832", {691000, 5334000, 500}, {0, 0}, {1000, 1000}}; }

// The pond [100, 200] x [300, 400] of Munich in degrees, from gdaltransform.
const std::vector<Point2> kPondInDegrees = {{11.568530034, 48.133236781},
                                            {11.569872709, 48.133206747},
                                            {11.569917588, 48.134105539},
                                            {11.568574890, 48.134135573}};

absl::StatusOr<WaterFile> Read(const std::vector<Point2>& ring, const std::string& crs, const SceneFrame& frame) {
  return ParseWaterFile({CollectionText({FeatureText(PolygonText(ring), R"({"level_m":512.5})")}, crs)}, "f", frame);
}

std::string MessageOf(const absl::StatusOr<WaterFile>& file) {
  EXPECT_TRUE(absl::IsInvalidArgument(file.status())) << file.status();
  return std::string(file.status().message());
}

void ExpectPond(const absl::StatusOr<WaterFile>& file, const std::string& coordinates, double level, double off) {
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->coordinates, coordinates);
  ASSERT_THAT(file->areas, SizeIs(1));
  ASSERT_THAT(file->areas[0].polygon.rings, SizeIs(1));
  const std::vector<Point2> pond = SquareAt(100, 300, 100);
  for (size_t i = 0; i < 4; ++i) EXPECT_LT((file->areas[0].polygon.rings[0][i] - pond[i]).norm(), off) << i;
  EXPECT_EQ(file->areas[0].level, level);
}

TEST(CoordinateReadingTest, WithoutACrsThatWhichLiesInTheSceneIsMeant) {
  ExpectPond(Read(SquareAt(100, 300, 100), "", Munich()), "scene coordinates", 512.5, 1e-6);
  ExpectPond(Read(SquareAt(691100, 5334300, 100), "", Munich()), "EPSG:25832", 12.5, 1e-6);
  ExpectPond(Read(kPondInDegrees, "", Munich()), "longitude and latitude", 12.5, 0.05);
}

// A drawing has a frame around (0, 0), and its water in the scene's CRS.
TEST(CoordinateReadingTest, FeaturesThatAreMeantInTwoWaysAreAnError) {
  const auto read = [](const std::vector<std::vector<Point2>>& rings) {
    std::vector<std::string> features;
    for (const std::vector<Point2>& ring : rings) features.push_back(FeatureText(PolygonText(ring), "{}"));
    return ParseWaterFile({CollectionText(features, "")}, "f", Munich());
  };
  const auto water = SquareAt(691100, 5334300, 100), frame = SquareAt(0, 0, 420), far = SquareAt(-9000, -9000, 5);
  EXPECT_THAT(
      MessageOf(read({frame, water})),
      HasSubstr("of its 2 features 1 lie in the scene only if coordinates are relative to its origin, and 1 only "
                "if they are in its CRS"));
  const auto beside = read({far, water});  // one that lies nowhere does not matter
  ASSERT_TRUE(beside.ok()) << beside.status();
  EXPECT_EQ(beside->coordinates, "EPSG:25832");
}

TEST(CoordinateReadingTest, ANamedCrsIsTransformedToTheScenes) {
  ExpectPond(Read(SquareAt(691100, 5334300, 100), kUtm, Munich()), "EPSG:25832", 12.5, 1e-6);
  ExpectPond(Read(kPondInDegrees, "urn:ogc:def:crs:OGC:1.3:CRS84", Munich()), "EPSG:4326", 12.5, 0.05);
}

// As an export of photogrammetry has it; files drawn over it keep the code alone.
constexpr char kLocal[] =
    "PROJCS[\"local\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
    "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
    "PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",0.9996],"
    "PARAMETER[\"false_easting\",500000],PARAMETER[\"false_northing\",NORTHING],UNIT[\"metre\",1],"
    "AUTHORITY[\"EPSG\",\"32632\"]]";

TEST(CoordinateReadingTest, TheCodeOfAnotherCrsIsThatOfTheSceneIfThisHasIt) {
  const char named[] = "urn:ogc:def:crs:EPSG::32632";
  for (const std::string northing : {"90", "0"}) {
    SceneFrame frame = Munich();
    frame.crs = absl::StrReplaceAll(kLocal, {{"NORTHING", northing}});
    const auto read = Read(SquareAt(691100, 5334300, 100), named, frame);
    ExpectPond(read, "EPSG:32632", 12.5, 1e-6);
    EXPECT_THAT(read->warnings, SizeIs(northing == "0" ? 0 : 1));
    Scene scene;
    scene.crs = frame.crs;
    EXPECT_EQ(*CrsFaultOf(scene), northing == "0" ? "" : "is not EPSG:32632, as which it is marked");
  }
}

// A scene 6,000 km further north by its CRS: what lies in it is in the CRS that the file names.
TEST(CoordinateReadingTest, AFileThatDoesNotLieInTheSceneByItsCodeIsTransformed) {
  SceneFrame frame = Munich();
  frame.crs = absl::StrReplaceAll(kLocal, {{"NORTHING", "6000000"}});
  frame.origin.y() += 6000000;
  const auto read = Read(SquareAt(691100, 5334300, 100), "urn:ogc:def:crs:EPSG::32632", frame);
  ExpectPond(read, "EPSG:32632", 12.5, 1e-6);
  EXPECT_THAT(read->warnings, SizeIs(0));
}

TEST(CoordinateReadingTest, AVerticalCrsOfTheSceneDoesNotMatter) {
  SceneFrame frame = Munich();
  frame.crs = "EPSG:25832+7837";
  ExpectPond(Read(SquareAt(691100, 5334300, 100), kUtm, frame), "EPSG:25832", 12.5, 1e-6);
}

TEST(CoordinateReadingTest, SmallCoordinatesInASceneNearZeroAreNoDegrees) {
  SceneFrame frame = Munich();
  frame.hi = {60, 60};
  const auto file = Read(SquareAt(8, 40, 9), "", frame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->coordinates, "scene coordinates") << "as degrees it would be half of Europe, and hold the scene";
}

TEST(CoordinateReadingTest, ASceneOfEastAndNorthHasItsPlaceOnEarth) {
  const SceneFrame frame{"ENU:48.133236781,11.568530034", {0, 0, 0}, {-500, -500}, {500, 500}};
  const auto file = Read(kPondInDegrees, "", frame);
  ASSERT_TRUE(file.ok()) << file.status();
  const std::vector<Point2>& ring = file->areas[0].polygon.rings[0];
  EXPECT_LT(ring[0].norm(), 1e-3);
  EXPECT_NEAR((ring[1] - ring[0]).norm(), 100, 0.1);
  EXPECT_GT(ring[1].x(), 99);
  EXPECT_GT(ring[3].y(), 99);
}

TEST(CoordinateReadingTest, WithoutAnExtentAllAreSceneCoordinates) {
  ExpectPond(Read(SquareAt(100, 300, 100), "", {}), "scene coordinates", 512.5, 1e-6);
}

TEST(CoordinateReadingTest, ExchangedCoordinatesAreSaidToBe) {
  std::vector<Point2> utm = SquareAt(691100, 5334300, 100), degrees = kPondInDegrees;
  for (auto* ring : {&utm, &degrees}) {
    for (Point2& p : *ring) p.reverseInPlace();
  }
  for (const std::string crs : {"", kUtm}) {
    EXPECT_THAT(MessageOf(Read(utm, crs, Munich())), HasSubstr("with x and y exchanged")) << crs;
  }
  for (const std::string crs : {"", "EPSG:4326"}) {
    EXPECT_THAT(MessageOf(Read(degrees, crs, Munich())), HasSubstr("with x and y exchanged")) << crs;
  }
}

TEST(CoordinateReadingTest, WhatLiesNowhereInTheSceneNeedsACrs) {
  const std::vector<Point2> far = SquareAt(4000000, 300, 100);
  EXPECT_THAT(MessageOf(Read(far, "", Munich())), HasSubstr("the file names no CRS of its own"));
  const auto elsewhere = Read(SquareAt(700000, 5400000, 100), kUtm, Munich());
  EXPECT_TRUE(elsewhere.ok()) << "a file of all waters of a country is as good for any scene";
}

TEST(CoordinateReadingTest, ACrsNeedsOneOfTheScene) {
  SceneFrame frame = Munich();
  frame.crs = "";
  EXPECT_THAT(MessageOf(Read(kPondInDegrees, "EPSG:4326", frame)), HasSubstr("the scene names no CRS"));
  frame.crs = "Gauss, as ever";
  EXPECT_THAT(MessageOf(Read(kPondInDegrees, "EPSG:4326", frame)), HasSubstr("'Gauss, as ever' is not understood"));
  frame.crs = "EPSG:4326";
  EXPECT_THAT(MessageOf(Read(kPondInDegrees, "EPSG:4326", frame)), HasSubstr("has degrees"));
}

TEST(CoordinateReadingTest, ACrsThatIsNotKnownIsAnError) {
  EXPECT_THAT(MessageOf(Read(SquareAt(691100, 5334300, 100), "EPSG:999999", Munich())),
              HasSubstr("f: it names a CRS that is not known: 'EPSG:999999'"));
  EXPECT_THAT(MessageOf(Read(kPondInDegrees, "EPGS:4326", Munich())), HasSubstr("'EPGS:4326'")) << "and not degrees";
  EXPECT_THAT(
      MessageOf(ParseWaterFile({R"({"type":"Polygon","crs":{"type":"link"},"coordinates":[]})"}, "f", Munich())),
      HasSubstr("f: crs: expected"));
}

TEST(CoordinateReadingTest, CoordinatesThatAreNoneOfTheirCrsAreAnError) {
  EXPECT_THAT(MessageOf(Read(SquareAt(691100, 5334300, 100), "EPSG:4326", Munich())), HasSubstr("none of EPSG:4326"));
  EXPECT_THAT(MessageOf(Read({{0, 0}, {1, 0}, {1e10, 1}}, "", {})), HasSubstr("at most 1e9 m from the origin"));
}

}  // namespace
}  // namespace tilemend
