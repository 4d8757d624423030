#include "common/gis/geo_package.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::SizeIs;

TEST(GeoPackageOfTest, IsReadBackAsWater) {
  const std::string pond = FeatureText(PolygonText(SquareAt(691100, 5334300, 100)),
                                       R"({"name": "Pond", "water": true, "level_m": null, "clear": true})");
  const auto package = GeoPackageOf(CollectionText({pond}, "urn:ogc:def:crs:EPSG::25832"), "water", "out.gpkg");
  ASSERT_TRUE(package.ok()) << package.status();
  const SceneFrame frame{"EPSG:25832", {691000, 5334000, 500}, {0, 0}, {1000, 1000}};
  const auto file = ParseWaterFile({*package}, "out.gpkg", frame);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->coordinates, "EPSG:25832");
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_TRUE(file->areas[0].water && file->areas[0].clear);
  EXPECT_EQ(file->areas[0].label, "feature 0 (Pond)");
  EXPECT_TRUE(Contains(file->areas[0].polygon, {150, 350}));
}

TEST(GeoPackageOfTest, WhatIsNoGeoJsonIsAnError) {
  const absl::Status status = GeoPackageOf("rubbish", "water", "out.gpkg").status();
  EXPECT_TRUE(absl::IsInternal(status)) << status;
}

}  // namespace
}  // namespace tilemend
