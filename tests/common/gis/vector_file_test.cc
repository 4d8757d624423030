// The formats that ReadVectors reads (vector_file.h), through the module as the programs load it.
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <optional>
#include <string>

#include "common/gis/area_file.h"
#include "common/util/files.h"
#include "tests/common/gis/geojson_text.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A GeoPackage as a GIS writes it.
class Package {
 public:
  explicit Package(const std::string& path) {
    GDALAllRegister();
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    data_.reset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  }

  // With the fields name, water and level_m. `epsg` 0: no CRS.
  OGRLayer* AddLayer(const char* name, int epsg, OGRwkbGeometryType type = wkbPolygon) {
    OGRSpatialReference crs;
    if (epsg != 0) crs.importFromEPSG(epsg);
    OGRLayer* const layer = data_->CreateLayer(name, epsg != 0 ? &crs : nullptr, type, nullptr);
    OGRFieldDefn text("name", OFTString), water("water", OFTInteger), level("level_m", OFTReal);
    water.SetSubType(OFSTBoolean);
    for (OGRFieldDefn* field : {&text, &water, &level}) EXPECT_EQ(layer->CreateField(field), OGRERR_NONE);
    return layer;
  }

  static void Add(OGRLayer* layer, const std::string& geojson, const char* name, bool water,
                  std::optional<double> level) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetGeometryDirectly(OGRGeometryFactory::createFromGeoJson(geojson.c_str()));
    feature.SetField("name", name);
    feature.SetField("water", water ? 1 : 0);
    if (level) feature.SetField("level_m", *level);
    EXPECT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }

 private:
  GDALDatasetUniquePtr data_;
};

const SceneFrame kFrame{"EPSG:25832", {691000, 5334000, 500}, {0, 0}, {1000, 1000}};  // NOLINT(cert-err58-cpp)

TEST(VectorFileTest, ReadsTheLayersOfAGeoPackage) {
  const TemporaryFolder folder;
  {
    Package package(folder / "lakes.gpkg");
    OGRLayer* const lakes = package.AddLayer("lakes", 25832);
    Package::Add(lakes, PolygonText(SquareAt(691100, 5334300, 100)), "Pond", true, 512);
    Package::Add(lakes, PolygonText(SquareAt(691400, 5334300, 100)), "Field", false, 0);
    Package::Add(lakes, PolygonText(SquareAt(691700, 5334300, 100)), "River", true, std::nullopt);
    Package::Add(package.AddLayer("lines", 25832, wkbLineString), LineText({{691710, 5334310}, {691790, 5334390}}), "",
                 true, 0);
    package.AddLayer("notes", 0, wkbNone);
  }
  const auto bytes = ReadAreaFile(folder / "lakes.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto file = ParseWaterFile(*bytes, "lakes.gpkg", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->coordinates, "EPSG:25832");
  ASSERT_THAT(file->areas, SizeIs(3));
  EXPECT_EQ(file->areas[0].label, "lakes, feature 1 (Pond)");
  EXPECT_EQ(file->areas[0].level, 12);
  EXPECT_TRUE(Contains(file->areas[0].polygon, {150, 350}));
  EXPECT_FALSE(file->areas[1].water);
  EXPECT_THAT(file->areas[2].centreline, SizeIs(2));
  EXPECT_THAT(file->warnings, IsEmpty());
  const std::string area = ParseAreaFile(*bytes, "lakes.gpkg", kFrame).status().ToString();
  EXPECT_THAT(area, HasSubstr("expected one layer of polygons, found 2: lakes, lines"));
}

TEST(VectorFileTest, LayersOfPointsAndEmptyOnesDoNotMatter) {
  const TemporaryFolder folder;
  {
    Package package(folder / "area.gpkg");
    OGRLayer* const trees = package.AddLayer("trees", 25832, wkbPoint25D);
    Package::Add(trees, R"({"type":"Point","coordinates":[691100,5334300,5]})", "Oak", true, 0);
    package.AddLayer("drafts", 4326);
    Package::Add(package.AddLayer("area", 25832), PolygonText(SquareAt(691100, 5334300, 100)), "", true, 0);
  }
  const auto bytes = ReadAreaFile(folder / "area.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto area = ParseAreaFile(*bytes, "area.gpkg", kFrame);
  ASSERT_TRUE(area.ok()) << area.status();
  EXPECT_TRUE(Contains(area->area, {150, 350}));
  const auto water = ParseWaterFile(*bytes, "area.gpkg", kFrame);
  ASSERT_TRUE(water.ok()) << water.status();
  EXPECT_THAT(water->areas, SizeIs(1));
}

TEST(VectorFileTest, AGeoPackageOfPointsHoldsNoPolygon) {
  const TemporaryFolder folder;
  {
    Package package(folder / "trees.gpkg");
    Package::Add(package.AddLayer("trees", 25832, wkbPoint), R"({"type":"Point","coordinates":[691100,5334300]})",
                 "Oak", true, 0);
  }
  const auto bytes = ReadAreaFile(folder / "trees.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_THAT(ParseAreaFile(*bytes, "trees.gpkg", kFrame).status().ToString(), HasSubstr("holds no polygon"));
  const auto water = ParseWaterFile(*bytes, "trees.gpkg", kFrame);
  ASSERT_TRUE(water.ok()) << water.status();
  EXPECT_THAT(water->warnings, SizeIs(1));
}

TEST(VectorFileTest, AGeoPackageWithoutACrsIsReadWhereItFits) {
  const TemporaryFolder folder;
  {
    Package package(folder / "area.gpkg");
    Package::Add(package.AddLayer("area", 0), PolygonText(SquareAt(100, 300, 100)), "", true, 0);
  }
  const auto bytes = ReadAreaFile(folder / "area.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto file = ParseAreaFile(*bytes, "area.gpkg", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->coordinates, "scene coordinates");
  EXPECT_TRUE(Contains(file->area, {150, 350}));
}

TEST(VectorFileTest, ADatabaseWithAWriteAheadLogThatIsEmptyIsRead) {
  const TemporaryFolder folder;
  {
    Package package(folder / "area.gpkg");
    Package::Add(package.AddLayer("area", 25832), PolygonText(SquareAt(691100, 5334300, 100)), "", true, 0);
  }
  auto bytes = ReadAreaFile(folder / "area.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  (*bytes)[18] = (*bytes)[19] = 2;  // as QGIS leaves it
  const auto file = ParseAreaFile(*bytes, "area.gpkg", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->area.rings, SizeIs(1));
}

TEST(VectorFileTest, OtherBytesAreRefusedByName) {
  const std::string broken = std::string("SQLite format 3\0", 16) + std::string(2000, '\x55');
  for (const std::string& bytes : {broken, broken.substr(0, 17), std::string("{}"), std::string(R"({"type": 7})"),
                                   std::string(R"({"type": "FeatureCollection"})"),
                                   std::string(R"({"type": "FeatureCollection", "features": {}})")}) {
    const absl::Status status = ParseWaterFile(bytes, "lakes.gpkg", kFrame).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("lakes.gpkg: neither GeoJSON nor GeoPackage"));
    EXPECT_THAT(std::string(status.message()), ::testing::Not(HasSubstr("vsimem")));
  }
}

TEST(VectorFileTest, ACutOffGeoPackageIsAnErrorOrWhatIsLeft) {
  const TemporaryFolder folder;
  {
    Package package(folder / "area.gpkg");
    Package::Add(package.AddLayer("area", 25832), PolygonText(SquareAt(691100, 5334300, 100)), "", true, 0);
  }
  const auto bytes = ReadFile(folder / "area.gpkg");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  for (size_t size = 0; size < bytes->size(); size += 1777) {
    const auto file = ParseAreaFile(bytes->substr(0, size), "area.gpkg", kFrame);
    if (file.ok()) continue;
    EXPECT_TRUE(absl::IsInvalidArgument(file.status())) << file.status();
    EXPECT_THAT(std::string(file.status().message()), HasSubstr("area.gpkg: ")) << size;
  }
}

}  // namespace
}  // namespace tilemend
