#include "common/gis/area_file.h"

#include <cpl_error.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "tests/common/gis/geojson_text.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(FrameOfTest, AGridHasAnExtentAndAMeshHasNone) {
  Scene scene;
  scene.crs = "EPSG:25832";
  scene.origin = {600000, 5000000, 400};
  EXPECT_GT(FrameOf(scene).lo.x(), FrameOf(scene).hi.x());
  scene.grid = {{-10, 20}, {100, 50}};
  scene.cols = 3;
  scene.rows = 2;
  const SceneFrame frame = FrameOf(scene);
  EXPECT_EQ(frame.lo, Point2(-10, 20));
  EXPECT_EQ(frame.hi, Point2(290, 120));
  EXPECT_EQ(frame.crs, "EPSG:25832");
  EXPECT_EQ(frame.origin, scene.origin);
}

TEST(IsInMetresTest, ProjAgrees) {
  const CPLErrorHandlerPusher quiet(CPLQuietErrorHandler);
  int in_metres = 0;
  for (int code = 0; code <= 40000; ++code) {
    const std::string name = "EPSG:" + std::to_string(code);
    if (!IsInMetres(name)) continue;
    ++in_metres;
    OGRSpatialReference crs;
    EXPECT_EQ(crs.SetFromUserInput(name.c_str()), OGRERR_NONE) << name;
    EXPECT_TRUE(crs.IsProjected()) << name;
    EXPECT_EQ(crs.GetLinearUnits(), 1) << name;
  }
  EXPECT_EQ(in_metres, 60 + 60 + 11);
}

TEST(IsInMetresTest, HoldsForPlacesOnEarth) {
  for (const char* crs : {"ENU:48.1,11.5", "ENU:-90,180", "ENU:0,-0.5"}) EXPECT_TRUE(IsInMetres(crs)) << crs;
  for (const char* crs : {"", "ENU:91,0", "ENU:0,181", "ENU:nan,0", "ENU:48.1", "ENU:48.1,11.5 ", "EPSG:4326",
                          "EPSG:", "EPSG:32632 ", "EPSG:32632+5773", "EPSG:-32632", "rubbish"}) {
    EXPECT_FALSE(IsInMetres(crs)) << crs;
  }
}

TEST(CrsFaultOfTest, PeopleAreToldWhatIsWrong) {
  Scene scene;
  for (const auto& [crs, message] :
       std::vector<std::pair<std::string, std::string>>{{"", ""},
                                                        {"EPSG:32650", ""},
                                                        {"EPSG:31467", ""},
                                                        {"EPSG:4326", "has degrees"},
                                                        {"EPSG:2263", "has the unit US survey foot"},
                                                        {"EPSG:4978", "is geocentric"},
                                                        {"rubbish", "PROJ knows no"}}) {
    scene.crs = crs;
    const auto fault = CrsFaultOf(scene);
    ASSERT_TRUE(fault.ok()) << fault.status();
    EXPECT_EQ(fault->empty(), message.empty()) << *fault;
    EXPECT_THAT(*fault, HasSubstr(message));
  }
}

// As the peak of what its children took tells.
TEST(CrsFaultOfTest, ANameThatTellsTakesNoProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto ask = [](const char* crs) {
    Scene scene;
    scene.crs = crs;
    const auto fault = CrsFaultOf(scene);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    std::exit(!fault.ok() || !fault->empty() ? 2 : children.ru_maxrss > 0 ? 1 : 0);
  };
  EXPECT_EXIT(ask("EPSG:32650"), ::testing::ExitedWithCode(0), "");
  EXPECT_EXIT(ask("ENU:48.1,11.5"), ::testing::ExitedWithCode(0), "");
  EXPECT_EXIT(ask("EPSG:31467"), ::testing::ExitedWithCode(1), "") << "the test sees a process";
}

TEST(ParseWaterFileTest, ALineOfItsOwnIsTheCentrelineOfTheWaterAroundIt) {
  const std::string text = CollectionText({FeatureText(LineText({{1, 5}, {5, 5}, {12, 5}})),
                                           FeatureText(PolygonText(SquareAt(0, 0, 100)), R"({"water":false})"),
                                           FeatureText(PolygonText(SquareAt(0, 0, 10)), R"({"name":"Isar"})"),
                                           FeatureText(PolygonText(SquareAt(50, 50, 10)))});
  const auto file = ParseWaterFile({text}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(3));
  EXPECT_THAT(file->areas[0].centreline, IsEmpty()) << "no water";
  EXPECT_THAT(file->areas[1].centreline, ElementsAre(Point2(1, 5), Point2(5, 5), Point2(12, 5)));
  EXPECT_EQ(file->areas[1].label, "feature 2 (Isar)");
  EXPECT_THAT(file->areas[2].centreline, IsEmpty());
  EXPECT_THAT(file->warnings, IsEmpty());
}

TEST(ParseWaterFileTest, ALineInNoWaterIsAWarning) {
  const auto file = ParseWaterFile({CollectionText({FeatureText(LineText({{1, 5}, {5, 5}}))})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas, IsEmpty());
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 0: a line that lies in no polygon")));
}

TEST(ParseWaterFileTest, AStrayCentrelineIsAWarning) {
  const std::string square = PolygonText(SquareAt(0, 0, 10));
  const auto file = ParseWaterFile({FeatureText(square, R"({"centreline":[[1001,1],[1002,2]]})")}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_THAT(file->areas[0].centreline, IsEmpty());
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 0: its property centreline lies outside its polygon")));
}

TEST(ParseWaterFileTest, ACentrelineWithoutEffectIsAWarning) {
  const std::string square = PolygonText(SquareAt(0, 0, 10));
  const std::pair<std::string, std::string> cases[] = {
      {FeatureText(square, R"({"centreline":[[1,1],[1,1]]})"), "it has no length"},
      {CollectionText({FeatureText(square), FeatureText(LineText({{2, 5}, {2.1, 5}, {2.2, 5}}))}), "it has no length"},
      {FeatureText(square, R"({"level_m":9.2,"centreline":[[1,1],[9,9]]})"), "level_m is given as well"},
      {CollectionText({FeatureText(square, R"({"level_m":9.2})"), FeatureText(LineText({{1, 5}, {9, 5}}))}),
       "level_m is given as well"}};
  for (const auto& [text, reason] : cases) {
    const auto file = ParseWaterFile({text}, "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_THAT(file->areas[0].centreline, IsEmpty()) << text;
    EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 0: its centreline has no effect, since " + reason)));
  }
}

TEST(ParseWaterFileTest, AFileWithoutFeaturesIsAWarning) {
  const auto file = ParseWaterFile({CollectionText({})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings, ElementsAre("f: holds no polygon, so it has no effect"));
}

TEST(ParseWaterFileTest, TwoCentrelinesOfOneWaterAreAnError) {
  const std::string line = LineText({{1, 5}, {5, 5}}), square = PolygonText(SquareAt(0, 0, 10));
  for (const std::string& text :
       {CollectionText({FeatureText(square), FeatureText(line), FeatureText(line)}),
        CollectionText({FeatureText(square, R"({"centreline":[[1,1],[2,2]]})"), FeatureText(line)})}) {
    const absl::Status status = ParseWaterFile({text}, "f", {}).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("a second centreline of feature 0"));
  }
}

TEST(ParseWaterFileTest, AnEmptyCollectionHasNone) {
  const auto file = ParseWaterFile({CollectionText({})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas, IsEmpty());
}

TEST(ParseWaterFileTest, BrokenJsonIsToldWithItsPlace) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "f: not JSON: byte 1"},
           {"{\n \"type\": \"Polygon\",\n \"coordinates\": [}", "line 3, column 18"},
           {"[1]", "f: GeoJSON: expected an object"}}) {
    const absl::Status status = ParseWaterFile({text}, "f", {}).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(message)) << text;
  }
}

TEST(ParseWaterFileTest, BytesOfNoFormatAreRefused) {
  const std::string shapefile("\0\0\x27\x0a\0\0\0\0", 8);
  for (const std::string& bytes : {shapefile, std::string("<?xml version=\"1.0\"?><kml/>"), std::string("PK\3\4"),
                                   std::string("0\nSECTION\n"), std::string("lakes are here")}) {
    for (const absl::Status& status :
         {ParseWaterFile({bytes}, "a.shp", {}).status(), ParseAreaFile({bytes}, "a.shp", {}).status()}) {
      EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
      EXPECT_THAT(std::string(status.message()), ::testing::StartsWith("a.shp: a"));
    }
  }
}

TEST(ParseWaterFileTest, JsonMayBeginWithAMarkOfTheByteOrder) {
  EXPECT_TRUE(ParseWaterFile({"\xEF\xBB\xBF\n" + CollectionText({})}, "f", {}).ok());
}

TEST(ParseWaterFileTest, LinesInNoWaterAreCounted) {
  const std::string line = FeatureText(LineText({{1, 5}, {5, 5}}));
  const auto file = ParseWaterFile({CollectionText({line, line, line})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 0 and 2 more: a line that lies in no polygon")));
}

TEST(ParseWaterFileTest, AClearHeightWithoutEffectIsAWarning) {
  const std::string square = PolygonText(SquareAt(0, 0, 10));
  for (const auto& [properties, reason] : std::vector<std::pair<std::string, std::string>>{
           {R"({"clear_height": 2})", "is not given as well"},
           {R"({"clear_height": 2, "clear": true, "water": false})", "of what is no water all is taken out"}}) {
    const auto file = ParseWaterFile({FeatureText(square, properties)}, "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_THAT(file->warnings, ElementsAre(HasSubstr(reason)));
  }
}

TEST(ParseWaterFileTest, ClearedWaterIsLevel) {
  const std::string square = PolygonText(SquareAt(0, 0, 10));
  const auto with = [&](const char* properties) { return ParseWaterFile({FeatureText(square, properties)}, "f", {}); };
  const auto lake = with(R"({"clear": "yes", "clear_height": "2 m", "kind": "lake"})");
  ASSERT_TRUE(lake.ok()) << lake.status();
  EXPECT_THAT(lake->warnings, IsEmpty());
  EXPECT_TRUE(lake->areas[0].clear);
  EXPECT_EQ(lake->areas[0].clear_height, 2);
  EXPECT_EQ(lake->areas[0].kind, WaterKind::kLake);
  const absl::Status river = with(R"({"clear": true, "kind": "river"})").status();
  EXPECT_TRUE(absl::IsInvalidArgument(river)) << river;
  EXPECT_THAT(std::string(river.message()), HasSubstr("f: feature 0: kind is river, but clear"));
  const auto line = with(R"({"clear": true, "centreline": [[1, 1], [9, 9]]})");
  ASSERT_TRUE(line.ok()) << line.status();
  EXPECT_THAT(line->areas[0].centreline, IsEmpty());
  EXPECT_THAT(line->warnings, ElementsAre(HasSubstr("its centreline has no effect, since the area is cleared")));
}

TEST(ParseWaterFileTest, AKindMustAgreeWithTheRest) {
  const std::string square = PolygonText(SquareAt(0, 0, 10));
  const auto with = [&](const char* properties) { return ParseWaterFile({FeatureText(square, properties)}, "f", {}); };
  const absl::Status river = with(R"({"kind": "river", "level_m": 3, "name": "Isar"})").status();
  EXPECT_TRUE(absl::IsInvalidArgument(river)) << river;
  EXPECT_THAT(std::string(river.message()), HasSubstr("f: feature 0 (Isar): kind is river, but level_m"));
  const auto lake = with(R"({"kind": "lake", "centreline": [[1, 1], [9, 9]]})");
  ASSERT_TRUE(lake.ok()) << lake.status();
  EXPECT_THAT(lake->areas[0].centreline, IsEmpty());
  EXPECT_THAT(lake->warnings, ElementsAre(HasSubstr("its centreline has no effect, since kind is lake")));
  const auto dry = with(R"({"kind": "lake", "water": false})");
  ASSERT_TRUE(dry.ok()) << dry.status();
  EXPECT_EQ(dry->areas[0].kind, WaterKind::kUnsaid);
  EXPECT_THAT(dry->warnings, ElementsAre(HasSubstr("kind has no effect, since water is false")));
}

TEST(ParseAreaFileTest, PolygonsAreUnitedWhereTheyOverlap) {
  const std::string text =
      CollectionText({FeatureText(PolygonText(SquareAt(0, 0, 10))), FeatureText(PolygonText(SquareAt(5, 0, 10))),
                      FeatureText(PolygonText(SquareAt(40, 0, 10)))});
  const auto file = ParseAreaFile({text}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->area.rings, SizeIs(2));
  for (const double x : {1, 7, 12, 45}) EXPECT_TRUE(Contains(file->area, {x, 5})) << x;
  EXPECT_FALSE(Contains(file->area, {20, 5}));
}

// As parcels of a register are. Each with all before it would take minutes.
TEST(ParseAreaFileTest, ManyPolygonsAreUnitedInAMoment) {
  constexpr int kSide = 100;
  std::vector<std::string> parcels;
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) parcels.push_back(FeatureText(PolygonText(SquareAt(2 * x, 2 * y, 1))));
  }
  const auto start = std::chrono::steady_clock::now();
  const auto file = ParseAreaFile({CollectionText(parcels)}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1));
  EXPECT_THAT(file->area.rings, SizeIs(kSide * kSide));
}

TEST(ParseAreaFileTest, OnePolygonIsTakenAsItIs) {
  const auto file = ParseAreaFile({PolygonText({{0, 0}, {9, 0}, {0, 7}})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->area.rings, ElementsAre(ElementsAre(Point2(0, 0), Point2(9, 0), Point2(0, 7))));
}

TEST(ParseAreaFileTest, WithoutAPolygonThereIsNoArea) {
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {CollectionText({}), "f: holds no polygon"},
           {LineText({{0, 0}, {1, 1}}), "f: feature 0: a line: expected Polygon or MultiPolygon"}}) {
    const absl::Status status = ParseAreaFile({text}, "f", {}).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(message));
  }
}

}  // namespace
}  // namespace tilemend
