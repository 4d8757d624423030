#include "coordinator/report/scene_geojson.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <string>

#include "absl/strings/str_replace.h"
#include "common/gis/area_file.h"
#include "coordinator/report/scene_member.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A lake of two cells with an island, filled, and a closed hole that is left.
class SceneGeoJsonTest : public ::testing::Test {
 protected:
  SceneGeoJsonTest() {
    scene_.crs = "EPSG:25832";
    scene_.origin = {600000, 5000000, 400};
    scene_.grid = {{0, 0}, {100, 100}};
    scene_.cols = 2;
    scene_.rows = 1;
    AddRing({{60, 10}, {100, 10}, {100, 90}, {60, 90}});   // 0 to 3
    AddRing({{140, 10}, {140, 90}});                       // 4, 5
    AddRing({{70, 20}, {70, 30}, {80, 30}, {80, 20}});     // 6 to 9
    AddRing({{10, 10}, {20, 10.25}, {20, 20}, {10, 20}});  // 10 to 13
    AddHole({0, 0}, HoleKind::kOpenI, {{0, 1}, {1, 2, true}, {2, 3}, {3, 0}, {6, 7}, {7, 8}, {8, 9}, {9, 6}}).water = 0;
    AddHole({1, 0}, HoleKind::kOpenII, {{1, 4}, {4, 5}, {5, 2}, {2, 1, true}}).water = 0;
    AddHole({0, 0}, HoleKind::kClosed, {{10, 11}, {11, 12}, {12, 13}, {13, 10}});
    plan_.water = {{BodyKind::kWater, {0, 1}, 12.5, {}, {}}};
    plan_.lattice_step = 0x1p-10;
    input_.plan = &plan_;
    input_.outcome.sizes = {{0, {11, 22, FillWay::kWater}}, {1, {33, 44, FillWay::kWater}}};
    input_.outcome.failures = {{2, "no \"way\" was found"}};
    GDALAllRegister();
  }
  void AddRing(const std::vector<Point2>& points) {
    for (const Point2& p : points) plan_.vertices.push_back({{0, 0}, 0, {p.x(), p.y(), 12.5}});
  }
  PlannedHole& AddHole(CellId cell, HoleKind kind, const std::vector<RimSegment>& segments) {
    PlannedHole& hole = plan_.holes.emplace_back();
    hole.cell = cell;
    hole.kind = kind;
    hole.type = kind == HoleKind::kClosed ? HoleType::kNone : HoleType::kB;
    hole.cluster = kind == HoleKind::kClosed ? -1 : 0;
    hole.area = 100;
    hole.segments = segments;
    return hole;
  }
  // As GDAL reads it.
  GDALDatasetUniquePtr Read(const std::string& text) {
    const std::string path = folder_.Write("read.geojson", text);
    return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  }

  TemporaryFolder folder_;
  Scene scene_;
  Plan plan_;
  SceneReportInput input_;
};

TEST_F(SceneGeoJsonTest, GdalReadsTheHolesInTheCrsOfTheScene) {
  const auto data = Read(HolesGeoJson(input_, scene_));
  ASSERT_NE(data, nullptr);
  OGRLayer* const layer = data->GetLayer(0);
  ASSERT_NE(layer->GetSpatialRef(), nullptr);
  EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  ASSERT_EQ(layer->GetFeatureCount(), 3);
  const std::unique_ptr<OGRFeature> lake(layer->GetNextFeature()), beyond(layer->GetNextFeature()),
      left(layer->GetNextFeature());
  const OGRPolygon& polygon = *lake->GetGeometryRef()->toPolygon();
  EXPECT_EQ(polygon.getNumInteriorRings(), 1);
  EXPECT_NEAR(polygon.get_Area(), 40 * 80 - 100, 1e-6);
  EXPECT_STREQ(lake->GetFieldAsString("cell"), "+000_+000");
  EXPECT_STREQ(lake->GetFieldAsString("hole_kind"), "I");
  EXPECT_STREQ(lake->GetFieldAsString("kind"), "lake");
  EXPECT_EQ(lake->GetFieldAsInteger("water"), 1);
  EXPECT_EQ(lake->GetFieldAsInteger("body"), 0);
  EXPECT_FALSE(left->IsFieldSetAndNotNull(left->GetFieldIndex("water")));
  EXPECT_STREQ(lake->GetFieldAsString("type"), "B");
  EXPECT_STREQ(lake->GetFieldAsString("method"), "water");
  EXPECT_STREQ(lake->GetFieldAsString("outcome"), "filled");
  EXPECT_EQ(lake->GetFieldAsDouble("level_m"), 412.5);
  EXPECT_EQ(lake->GetFieldAsInteger("cluster"), 0);
  EXPECT_NEAR(beyond->GetGeometryRef()->toPolygon()->get_Area(), 40 * 80, 1e-6);
  EXPECT_STREQ(left->GetFieldAsString("outcome"), "left");
  EXPECT_STREQ(left->GetFieldAsString("reason"), "no \"way\" was found");
  EXPECT_FALSE(left->IsFieldSetAndNotNull(left->GetFieldIndex("cluster")));
  OGREnvelope box;
  left->GetGeometryRef()->getEnvelope(&box);
  EXPECT_EQ(box.MinX, 600010);
  EXPECT_EQ(box.MaxY, 5000020);
}

TEST_F(SceneGeoJsonTest, SaysWhatAHoleWasTakenForAndWhy) {
  plan_.holes[0].evidence = 0;
  plan_.evidence = {{HoleEvidence::Verdict::kLake, true, 12.5, 0.04, "the sides agree"}};
  plan_.water[0].sigma = 0.04;
  const auto data = Read(HolesGeoJson(input_, scene_));
  const std::unique_ptr<OGRFeature> lake(data->GetLayer(0)->GetNextFeature()),
      beyond(data->GetLayer(0)->GetNextFeature());
  EXPECT_STREQ(lake->GetFieldAsString("taken_for"), "lake");
  EXPECT_STREQ(lake->GetFieldAsString("because"), "the sides agree");
  EXPECT_EQ(lake->GetFieldAsDouble("sigma_m"), 0.04);
  EXPECT_STREQ(beyond->GetFieldAsString("taken_for"), "lake") << "a part of it";
  EXPECT_FALSE(beyond->IsFieldSetAndNotNull(beyond->GetFieldIndex("because")));
}

TEST_F(SceneGeoJsonTest, LevelGroundHasNoShore) {
  plan_.water[0].kind = BodyKind::kLevelGround;
  EXPECT_EQ(BreaklinesGeoJson(input_, scene_).find("shore"), std::string::npos);
}

TEST_F(SceneGeoJsonTest, ALakeOverTwoCellsHasOneShore) {
  const std::string text = BreaklinesGeoJson(input_, scene_);
  const auto data = Read(text);
  ASSERT_NE(data, nullptr);
  OGRLayer* const layer = data->GetLayer(0);
  ASSERT_EQ(layer->GetFeatureCount(), 1);
  const std::unique_ptr<OGRFeature> lake(layer->GetNextFeature());
  EXPECT_NEAR(lake->GetGeometryRef()->toPolygon()->get_Area(), 80 * 80 - 100, 1e-6);
  EXPECT_EQ(lake->GetFieldAsDouble("level_m"), 412.5);
  EXPECT_EQ(lake->GetGeometryRef()->toPolygon()->getExteriorRing()->getZ(0), 412.5);
  const auto again = ParseWaterFile({text}, "breaklines.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_THAT(again->areas, SizeIs(1));
  EXPECT_EQ(again->areas[0].level, 12.5);
  EXPECT_EQ(again->areas[0].kind, WaterKind::kLake);
  EXPECT_TRUE(tilemend::Contains(again->areas[0].polygon, {120, 50}));
  EXPECT_FALSE(tilemend::Contains(again->areas[0].polygon, {75, 25})) << "the island";
}

TEST_F(SceneGeoJsonTest, HolesRepeatWhatAPolygonSaid) {
  plan_.holes[0].evidence = 0;
  plan_.holes[2].evidence = 1;
  plan_.evidence.resize(2);
  for (const int32_t e : {0, 1}) plan_.evidence[e].area = e;
  plan_.water_answers = {{"pond", true, true, {0}, ""}, {"cars", false, true, {2}, ""}};
  plan_.water_answers[0].clear_height = 2.5;
  plan_.water_answers[1].clear_height = 1.5;
  const auto again = ParseWaterFile({HolesGeoJson(input_, scene_)}, "holes.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_THAT(again->warnings, IsEmpty());
  const auto cars = std::ranges::find(again->areas, false, &WaterArea::water);
  const auto pond = std::ranges::find(again->areas, 2.5, &WaterArea::clear_height);
  ASSERT_NE(cars, again->areas.end());
  ASSERT_NE(pond, again->areas.end());
  EXPECT_TRUE(cars->clear);
  EXPECT_TRUE(pond->clear && pond->water);
}

TEST_F(SceneGeoJsonTest, HolesCanBeGivenBackAsWater) {
  plan_.holes[2].segments.pop_back();  // lines; of no effect, as it is dry
  const auto again = ParseWaterFile({HolesGeoJson(input_, scene_)}, "holes.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_THAT(again->areas, SizeIs(1)) << "one body";
  EXPECT_EQ(again->areas[0].label, "feature 0 and 1 more");
  EXPECT_EQ(again->areas[0].level, 12.5);
  EXPECT_EQ(again->areas[0].kind, WaterKind::kLake);
  for (const double x : {65, 120}) EXPECT_TRUE(tilemend::Contains(again->areas[0].polygon, {x, 50})) << x;
  EXPECT_FALSE(tilemend::Contains(again->areas[0].polygon, {75, 25})) << "the island";
  EXPECT_THAT(again->warnings, ElementsAre(HasSubstr("holes.geojson: feature 2: holes whose property water is empty")));
}

// Who gives the file back as it was written gives no level.
TEST_F(SceneGeoJsonTest, ALevelThatNobodyChangedStaysAnEstimate) {
  plan_.holes[1].evidence = 0;  // the other is too small for one
  plan_.evidence = {{HoleEvidence::Verdict::kLake, true, 12.5, 0.04, "the sides agree"}};
  plan_.water[0].sigma = 0.04;
  const auto given = [&](const std::string& from, const std::string& to) {
    std::string text = HolesGeoJson(input_, scene_);
    text = absl::StrReplaceAll(text, {{from, to}});
    const auto file = ParseWaterFile({text}, "holes.geojson", FrameOf(scene_));
    EXPECT_TRUE(file.ok()) << file.status();
    return file->areas.at(0);
  };
  const WaterArea same = given(" ", " ");
  EXPECT_EQ(same.level, 12.5);
  EXPECT_EQ(same.level_sigma, 0.04);
  EXPECT_TRUE(same.is_as_found);
  const WaterArea other = given(R"("level_m":412.5)", R"("level_m":412.75)");
  EXPECT_EQ(other.level, 12.75);
  EXPECT_EQ(other.level_sigma, std::nullopt);
  EXPECT_FALSE(other.is_as_found);
  const WaterArea river = given(R"("kind":"lake","level_m":412.5)", R"("kind":"river","level_m":null)");
  EXPECT_EQ(river.level, std::nullopt);
  EXPECT_FALSE(river.is_as_found);
  plan_.water[0].forced = true;  // a polygon said that it is water, but no level
  EXPECT_EQ(given(" ", " ").level_sigma, 0.04);
  EXPECT_FALSE(given(" ", " ").is_as_found);
  plan_.water[0].level_is_given = true;
  EXPECT_EQ(given(" ", " ").level_sigma, std::nullopt);
}

// The lake is one hole over two cells, with a row for each.
TEST_F(SceneGeoJsonTest, RowsOfAHoleFollowTheOneThatIsChanged) {
  plan_.holes[0].evidence = plan_.holes[1].evidence = 0;
  plan_.evidence = {{HoleEvidence::Verdict::kLake, true, 12.5, 0.04, "the sides agree"}};
  plan_.water[0].sigma = 0.04;
  std::string text = HolesGeoJson(input_, scene_);
  const std::string level = R"("level_m":412.5)";
  text.replace(text.find(level), level.size(), R"("level_m":412.75)");
  const auto file = ParseWaterFile({text}, "holes.geojson", FrameOf(scene_));
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_EQ(file->areas[0].level, 12.75);
  EXPECT_FALSE(file->areas[0].is_as_found);
  for (const double x : {65, 120}) EXPECT_TRUE(tilemend::Contains(file->areas[0].polygon, {x, 50})) << x;
  text.replace(text.rfind(level), level.size(), R"("level_m":413.5)");
  EXPECT_THAT(ParseWaterFile({text}, "holes.geojson", FrameOf(scene_))->areas, SizeIs(2)) << "which differ";
}

TEST_F(SceneGeoJsonTest, ARiverAmongTheHolesIsOneWhenItIsGivenBack) {
  plan_.water[0].river.stations = {{65, 50, 13.5}, {135, 50, 12.5}};
  const auto again = ParseWaterFile({HolesGeoJson(input_, scene_)}, "holes.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_THAT(again->areas, SizeIs(1));
  EXPECT_EQ(again->areas[0].kind, WaterKind::kRiver);
  EXPECT_EQ(again->areas[0].level, std::nullopt);
}

TEST_F(SceneGeoJsonTest, HolesOfAReportWithoutWaterChangeNothing) {
  plan_.water.clear();
  for (PlannedHole& hole : plan_.holes) hole.water = -1;
  const auto again = ParseWaterFile({HolesGeoJson(input_, scene_)}, "holes.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_THAT(again->areas, SizeIs(0));
  EXPECT_THAT(again->warnings, Contains(HasSubstr("feature 0 and 2 more: holes whose property water is empty")));
}

TEST_F(SceneGeoJsonTest, ARiverHasACentrelineThatFalls) {
  plan_.water[0].river.stations = {{65, 50, 13.5}, {135, 50, 12.5}};
  const std::string text = BreaklinesGeoJson(input_, scene_);
  const auto data = Read(text);
  ASSERT_NE(data, nullptr);
  OGRLayer* const layer = data->GetLayer(0);
  ASSERT_EQ(layer->GetFeatureCount(), 2);
  const std::unique_ptr<OGRFeature> shore(layer->GetNextFeature()), line(layer->GetNextFeature());
  EXPECT_FALSE(shore->IsFieldSetAndNotNull(shore->GetFieldIndex("level_m")));
  EXPECT_EQ(shore->GetFieldAsDouble("highest_m"), 413.5);
  EXPECT_EQ(shore->GetFieldAsDouble("lowest_m"), 412.5);
  for (const OGRPoint& p : *shore->GetGeometryRef()->toPolygon()->getExteriorRing()) {
    const double along = std::clamp((p.getX() - 600065) / 70, 0.0, 1.0);
    EXPECT_NEAR(p.getZ(), 413.5 - along, 2e-3) << p.getX();
  }
  const OGRLineString& stations = *line->GetGeometryRef()->toLineString();
  EXPECT_EQ(stations.getX(0), 600065);
  EXPECT_EQ(stations.getZ(0), 413.5);
  EXPECT_EQ(stations.getZ(1), 412.5);
  const auto again = ParseWaterFile({text}, "breaklines.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_THAT(again->areas, SizeIs(1));
  EXPECT_THAT(again->areas[0].centreline, SizeIs(2));
  EXPECT_EQ(again->areas[0].kind, WaterKind::kRiver);
}

TEST_F(SceneGeoJsonTest, AHoleThatIsNotClosedIsItsRim) {
  plan_.holes[1].segments = {{1, 4}, {4, 5}, {5, 2, true}};  // a seam is no rim
  const auto data = Read(HolesGeoJson(input_, scene_));
  ASSERT_EQ(data->GetLayer(0)->GetFeatureCount(), 3);
  const std::unique_ptr<OGRFeature> hole(data->GetLayer(0)->GetFeature(1));
  EXPECT_NEAR(hole->GetGeometryRef()->toMultiLineString()->get_Length(), 40 + 80, 1e-6);
}

TEST_F(SceneGeoJsonTest, PolygonsAreValidHoweverTheRimCrossesItself) {
  plan_.holes[1].segments = {{1, 5}, {5, 4}, {4, 2}, {2, 1, true}};    // a bow-tie
  plan_.holes[2].segments = {{10, 12}, {12, 11}, {11, 13}, {13, 10}};  // the same, closed
  const auto data = Read(HolesGeoJson(input_, scene_));
  ASSERT_EQ(data->GetLayer(0)->GetFeatureCount(), 3);
  for (const auto& feature : data->GetLayer(0)) EXPECT_TRUE(feature->GetGeometryRef()->IsValid()) << feature->GetFID();
  const std::unique_ptr<OGRFeature> closed(data->GetLayer(0)->GetFeature(2));
  EXPECT_EQ(wkbFlatten(closed->GetGeometryRef()->getGeometryType()), wkbMultiPolygon) << "both sides of it";
  const auto shores = Read(BreaklinesGeoJson(input_, scene_));
  for (const auto& feature : shores->GetLayer(0)) EXPECT_TRUE(feature->GetGeometryRef()->IsValid());
}

TEST_F(SceneGeoJsonTest, AHoleThatIsNothingFromAboveIsItsRim) {
  for (PlanVertex& v : plan_.vertices) v.position.y() = 10;
  const auto data = Read(HolesGeoJson(input_, scene_));
  const std::unique_ptr<OGRFeature> hole(data->GetLayer(0)->GetFeature(2));
  EXPECT_EQ(wkbFlatten(hole->GetGeometryRef()->getGeometryType()), wkbMultiLineString);
}

TEST_F(SceneGeoJsonTest, SaysHowMuchOfTheRimIsOnObjects) {
  for (const int32_t v : {11, 12}) plan_.vertices[v].on_object = true;
  plan_.holes[2].segments.push_back({10, 5, true});  // a seam counts for nothing
  const auto data = Read(HolesGeoJson(input_, scene_));
  const std::unique_ptr<OGRFeature> hole(data->GetLayer(0)->GetFeature(2));
  ASSERT_NE(hole, nullptr);
  EXPECT_NEAR(hole->GetFieldAsDouble("share_on_objects"), 0.245, 0.001);
}

TEST_F(SceneGeoJsonTest, NamesWhateverCrsTheSceneHas) {
  const auto crs_of = [this](const std::string& crs) {
    scene_.crs = crs;
    const auto data = Read(HolesGeoJson(input_, scene_));
    const OGRSpatialReference* const read = data->GetLayer(0)->GetSpatialRef();
    return read == nullptr ? OGRSpatialReference() : *read;
  };
  EXPECT_STREQ(crs_of("EPSG:25832+7837").GetAuthorityCode(nullptr), "25832");
  EXPECT_TRUE(crs_of("").IsLocal()) << "not degrees";
  EXPECT_STREQ(crs_of("ENU:48.1,11.5").GetAttrValue("PROJECTION"), "Orthographic");
  OGRSpatialReference utm;
  utm.importFromEPSG(25832);
  char* wkt = nullptr;
  utm.exportToWkt(&wkt);
  EXPECT_TRUE(crs_of(wkt).IsSame(&utm));
  CPLFree(wkt);
}

TEST_F(SceneGeoJsonTest, AnAreaIsReadBack) {
  const PlanePolygon area{{{{0, 0}, {200, 0}, {200, 100}, {0, 100}}, {{50, 50}, {50, 60}, {60, 60}, {60, 50}}}};
  const auto again = ParseAreaFile({AreaGeoJson(area, scene_)}, "area.geojson", FrameOf(scene_));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->area.rings, area.rings);
  scene_.crs = "";
  const auto local = ParseAreaFile({AreaGeoJson(area, scene_)}, "area.geojson", FrameOf(scene_));
  ASSERT_TRUE(local.ok()) << local.status();
  EXPECT_EQ(local->area.rings, area.rings);
}

TEST_F(SceneGeoJsonTest, SaysWhichSceneItIsOf) {
  scene_.root = "/data/city";
  const auto holes = nlohmann::ordered_json::parse(HolesGeoJson(input_, scene_));
  EXPECT_EQ(holes[kSceneMember], SceneMemberOf(scene_));
}

TEST_F(SceneGeoJsonTest, WithoutHolesItIsAnEmptyCollection) {
  Plan none;
  input_.plan = &none;
  for (const std::string& text : {HolesGeoJson(input_, scene_), BreaklinesGeoJson(input_, scene_)}) {
    const auto data = Read(text);
    ASSERT_NE(data, nullptr);
    EXPECT_EQ(data->GetLayer(0)->GetFeatureCount(), 0);
  }
}

}  // namespace
}  // namespace tilemend
