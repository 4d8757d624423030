// The formats that ReadVectors reads (vector_file.h), through the process that the programs start.
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  bytes->bytes[18] = bytes->bytes[19] = 2;  // as QGIS leaves it
  const auto file = ParseAreaFile(*bytes, "area.gpkg", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->area.rings, SizeIs(1));
}

TEST(VectorFileTest, OtherBytesAreRefusedByName) {
  const std::string broken = std::string("SQLite format 3\0", 16) + std::string(2000, '\x55');
  for (const std::string& bytes : {broken, broken.substr(0, 17), std::string("{}"), std::string(R"({"type": 7})"),
                                   std::string(R"({"type": "FeatureCollection"})"),
                                   std::string(R"({"type": "FeatureCollection", "features": {}})")}) {
    const absl::Status status = ParseWaterFile({bytes}, "lakes.gpkg", kFrame).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr("lakes.gpkg: a file of no format that is read"));
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
    const auto file = ParseAreaFile({bytes->substr(0, size)}, "area.gpkg", kFrame);
    if (file.ok()) continue;
    EXPECT_TRUE(absl::IsInvalidArgument(file.status())) << file.status();
    EXPECT_THAT(std::string(file.status().message()), HasSubstr("area.gpkg: ")) << size;
  }
}

// How a lake of 100 m, its properties and its CRS are in the files of one driver.
struct Format {
  const char* driver;
  const char* file;
  int epsg = 25832;  // 0: none
  bool has_properties = true;
};

// What a test of that format is called.
std::string NameOf(const ::testing::TestParamInfo<Format>& info) {
  std::string name = info.param.file;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

// The scene's square of 100 m at (x, 300), as it is in a file with this CRS.
std::unique_ptr<OGRGeometry> SquareIn(int epsg, double x) {
  const Point2 corner = epsg != 0 ? Point2(691000 + x, 5334300) : Point2(x, 300);
  const std::string text = PolygonText(SquareAt(corner.x(), corner.y(), 100));
  std::unique_ptr<OGRGeometry> square(OGRGeometryFactory::createFromGeoJson(text.c_str()));
  OGRSpatialReference from, to;
  from.importFromEPSG(25832);
  to.importFromEPSG(epsg != 0 ? epsg : 25832);
  for (OGRSpatialReference* crs : {&from, &to}) crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&from, &to));
  EXPECT_EQ(square->transform(way.get()), OGRERR_NONE);
  return square;
}

// Two lakes, at x = 100 (a lake with a level, as text) and 400 (no water).
void WriteLakes(const Format& format, const std::string& path) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(format.driver);
  ASSERT_NE(driver, nullptr) << format.driver;
  const GDALDatasetUniquePtr data(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_NE(data, nullptr) << path;
  OGRSpatialReference crs;
  crs.importFromEPSG(format.epsg != 0 ? format.epsg : 25832);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const OGRwkbGeometryType type = format.has_properties ? wkbPolygon : wkbUnknown;
  CPLStringList options;
  if (EQUAL(format.driver, "FlatGeobuf")) options.SetNameValue("SPATIAL_INDEX", "NO");  // it would sort the features
  OGRLayer* const layer = data->CreateLayer("lakes", format.epsg != 0 ? &crs : nullptr, type, options.List());
  ASSERT_NE(layer, nullptr);
  for (const char* name : {"name", "water", "level_m", "kind"}) {
    OGRFieldDefn field(name, OFTString);
    field.SetWidth(20);
    if (!format.has_properties) continue;
    ASSERT_EQ(layer->CreateField(&field), OGRERR_NONE);
  }
  for (const double x : {100, 400}) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetGeometry(SquareIn(format.epsg, x).get());
    if (format.has_properties) {
      feature.SetField("name", x == 100 ? "Pond" : "Field");
      feature.SetField("water", x == 100 ? "T" : "F");
      if (x == 100) feature.SetField("level_m", "512.5 m");
      if (x == 100) feature.SetField("kind", "lake");
    } else {
      auto line = std::make_unique<OGRLineString>();
      line->addSubLineString(SquareIn(0, x)->toPolygon()->getExteriorRing());
      feature.SetGeometry(line.get());
    }
    ASSERT_EQ(layer->CreateFeature(&feature), OGRERR_NONE);
  }
}

class VectorFormatTest : public ::testing::TestWithParam<Format> {
 protected:
  // What is read of `path`.
  static void CheckLakes(const std::string& path, const Format& format) {
    const auto bytes = ReadAreaFile(path);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const auto file = ParseWaterFile(*bytes, path, kFrame);
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_THAT(file->areas, SizeIs(2));
    EXPECT_THAT(file->warnings, IsEmpty());
    for (const Point2& p : {Point2(101, 301), Point2(199, 399)}) EXPECT_TRUE(Contains(file->areas[0].polygon, p));
    EXPECT_FALSE(Contains(file->areas[0].polygon, {98, 350}));
    EXPECT_TRUE(Contains(file->areas[1].polygon, {450, 350}));
    if (!format.has_properties) return;
    EXPECT_THAT(file->areas[0].label, HasSubstr("(Pond)"));
    EXPECT_EQ(file->areas[0].level, 12.5);
    EXPECT_EQ(file->areas[0].kind, WaterKind::kLake);
    EXPECT_FALSE(file->areas[1].water);
    EXPECT_EQ(file->areas[1].level, std::nullopt);
    const auto area = ParseAreaFile(*bytes, path, kFrame);
    ASSERT_TRUE(area.ok()) << area.status();
    EXPECT_TRUE(Contains(area->area, {150, 350}) && Contains(area->area, {450, 350}));
  }

  const TemporaryFolder folder_;
};

TEST_P(VectorFormatTest, TwoLakesAreReadWithTheirProperties) {
  const std::string path = folder_ / GetParam().file;
  WriteLakes(GetParam(), path);
  CheckLakes(path, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Formats, VectorFormatTest,
                         ::testing::Values(Format{"ESRI Shapefile", "lakes.shp"}, Format{"OpenFileGDB", "lakes.gdb"},
                                           Format{"LIBKML", "lakes.kml", 4326}, Format{"LIBKML", "lakes.kmz", 4326},
                                           Format{"GML", "lakes.gml"}, Format{"FlatGeobuf", "lakes.fgb"},
                                           Format{"MapInfo File", "lakes.tab"}, Format{"MapInfo File", "lakes.mif"},
                                           Format{"GPKG", "lakes.gpkg"}, Format{"GeoJSON", "lakes.geojson", 4326},
                                           Format{"DXF", "lakes.dxf", 0, false}, Format{"DGN", "lakes.dgn", 0, false}),
                         NameOf);

// A ZIP archive of these files of a folder.
void Zip(const TemporaryFolder& folder, const std::vector<std::string>& names, const std::string& archive) {
  for (const std::string& name : names) {
    const auto bytes = ReadFile(folder / name);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    VSILFILE* const file = VSIFOpenL(("/vsizip/" + archive + "/" + name).c_str(), "wb");
    ASSERT_NE(file, nullptr);
    VSIFWriteL(bytes->data(), 1, bytes->size(), file);
    VSIFCloseL(file);
  }
}

TEST_F(VectorFormatTest, AShapefileInAnArchiveIsReadWithItsSideFiles) {
  const Format shapefile{"ESRI Shapefile", "lakes.shp"};
  WriteLakes(shapefile, folder_ / "lakes.shp");
  Zip(folder_, {"lakes.shp", "lakes.dbf", "lakes.shx", "lakes.prj"}, folder_ / "lakes.zip");
  CheckLakes(folder_ / "lakes.zip", shapefile);
}

TEST_F(VectorFormatTest, AnArchiveOfSeveralFilesIsReadInOrderOfTheirNames) {
  WriteLakes({"ESRI Shapefile", "", 25832}, folder_ / "b.shp");
  WriteLakes({"LIBKML", "", 4326}, folder_ / "a.kml");
  folder_.Write("readme.txt", "lakes");
  Zip(folder_, {"b.shp", "b.dbf", "b.shx", "b.prj", "a.kml", "readme.txt"}, folder_ / "all.zip");
  const auto bytes = ReadAreaFile(folder_ / "all.zip");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto file = ParseWaterFile(*bytes, "all.zip", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(4));
  EXPECT_EQ(file->areas[0].label, "lakes, feature 1 (Pond)");
  EXPECT_EQ(file->areas[2].label, "b, feature 0 (Pond)");
  Zip(folder_, {"readme.txt"}, folder_ / "none.zip");
  const auto none = ReadAreaFile(folder_ / "none.zip");
  ASSERT_TRUE(none.ok()) << none.status();
  EXPECT_THAT(ParseWaterFile(*none, "none.zip", kFrame).status().ToString(), HasSubstr("none.zip: an archive without"));
}

TEST_F(VectorFormatTest, AShapefileWithoutItsIndexAndProjectionIsRead) {
  WriteLakes({"ESRI Shapefile", ""}, folder_ / "lakes.shp");
  for (const char* beside : {"lakes.shx", "lakes.prj"}) std::filesystem::remove(folder_ / beside);
  CheckLakes(folder_ / "lakes.shp", {"ESRI Shapefile", ""});
}

TEST_F(VectorFormatTest, AShapefileWithoutItsPropertiesIsRefusedButForAnArea) {
  WriteLakes({"ESRI Shapefile", ""}, folder_ / "lakes.shp");
  Zip(folder_, {"lakes.shp", "lakes.shx", "lakes.prj"}, folder_ / "lakes.zip");
  std::filesystem::remove(folder_ / "lakes.dbf");
  for (const char* name : {"lakes.shp", "lakes.zip"}) {
    const auto bytes = ReadAreaFile(folder_ / name);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    EXPECT_THAT(ParseWaterFile(*bytes, name, kFrame).status().ToString(), HasSubstr("a shapefile without its .dbf"));
    EXPECT_TRUE(ParseAreaFile(*bytes, name, kFrame).ok());
  }
}

TEST_F(VectorFormatTest, ADamagedPrjIsWarnedOf) {
  WriteLakes({"ESRI Shapefile", ""}, folder_ / "lakes.shp");
  folder_.Write("lakes.prj", "no projection");
  const auto bytes = ReadAreaFile(folder_ / "lakes.shp");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const auto file = ParseWaterFile(*bytes, "lakes.shp", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings, testing::Contains(HasSubstr("its .prj names no CRS that is known")));
}

TEST_F(VectorFormatTest, OpenLinesOfADrawingAreLeftOut) {
  WriteLakes({"DXF", "", 0, false}, folder_ / "lakes.dxf");
  auto bytes = ReadAreaFile(folder_ / "lakes.dxf");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  const size_t end = bytes->bytes.rfind("  0\nENDSEC");
  ASSERT_NE(end, std::string::npos);
  size_t entities = bytes->bytes.find("ENTITIES");
  ASSERT_NE(entities, std::string::npos);
  entities = bytes->bytes.find('\n', entities) + 1;
  bytes->bytes.insert(entities,
                      "  0\nLINE\n  8\n0\n 10\n1\n 20\n1\n 11\n9\n 21\n9\n  0\nPOINT\n  8\n0\n 10\n5\n 20\n5\n");
  const auto file = ParseWaterFile(*bytes, "lakes.dxf", kFrame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas, SizeIs(2));
  EXPECT_THAT(file->warnings, ::testing::ElementsAre(HasSubstr("and 1 more: neither polygons nor closed lines")));
}

TEST_F(VectorFormatTest, ADrawingThatIsCutOffIsRefused) {
  WriteLakes({"DXF", "", 0, false}, folder_ / "lakes.dxf");
  auto bytes = ReadAreaFile(folder_ / "lakes.dxf");
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  bytes->bytes.resize(bytes->bytes.size() / 2);
  const absl::Status status = ParseWaterFile(*bytes, "lakes.dxf", kFrame).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("lakes.dxf: a drawing that is cut off"));
}

// A file may name others, on this machine or on another one. None is opened.
TEST_F(VectorFormatTest, WhatAFileRefersToIsNotRead) {
  WriteLakes({"ESRI Shapefile", "lakes.shp"}, folder_ / "lakes.shp");
  const std::string link = folder_ / "lakes.shp";
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.vrt", "<OGRVRTDataSource><OGRVRTLayer name=\"lakes\"><SrcDataSource>" + link +
                         "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>"},
           {"a.csv", "WKT,water\n\"POLYGON((0 0,1 0,1 1,0 0))\",1\n"},
           {"a.xml", "<OGRWFSDataSource><URL>http://127.0.0.1:9/</URL></OGRWFSDataSource>"}}) {
    const absl::Status status = ParseWaterFile({text}, name, kFrame).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << name << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(name + ": a file of no format")) << status;
  }
  const std::string net = R"(<kml xmlns="http://www.opengis.net/kml/2.2"><NetworkLink><Link><href>)" + link +
                          "</href></Link></NetworkLink></kml>";
  const auto kml = ParseWaterFile({net}, "a.kml", kFrame);
  EXPECT_TRUE(!kml.ok() || kml->areas.empty());
}

TEST_F(VectorFormatTest, DamagedFilesAreErrorsOrWhatIsLeft) {
  for (const Format& format : {Format{"ESRI Shapefile", "lakes.shp"}, Format{"LIBKML", "lakes.kml", 4326},
                               Format{"FlatGeobuf", "lakes.fgb"}, Format{"GML", "lakes.gml"}}) {
    WriteLakes(format, folder_ / format.file);
    const auto whole = ReadAreaFile(folder_ / format.file);
    ASSERT_TRUE(whole.ok()) << whole.status();
    for (size_t size = 1; size < whole->bytes.size(); size += whole->bytes.size() / 40 + 1) {
      VectorBytes cut = *whole;
      cut.bytes.resize(size);
      const auto file = ParseWaterFile(cut, format.file, kFrame);
      if (file.ok()) continue;
      EXPECT_THAT(std::string(file.status().message()), HasSubstr(format.file)) << size;
    }
  }
}

}  // namespace
}  // namespace tilemend
