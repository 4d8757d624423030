#include "coordinator/jobs/delivery_entry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/tiles3d/bounding_volume.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "common/grid/delivery_paths.h"

namespace tilemend {
namespace {

// Two cells of 250 m, 100 km east of the middle of a zone, where north is 0.9 degrees off.
Scene TwoCells() {
  Scene scene;
  scene.crs = "EPSG:25832";
  scene.origin = {600000, 5538630, 100};
  scene.grid.cell_size = {250, 250};
  scene.cols = 2;
  scene.rows = 1;
  scene.tiles = {{.cell = {0, 0}, .path = "a/a.osgb"}, {.cell = {1, 0}, .path = "b/b.osgb"}};
  EXPECT_TRUE(SetDeliveryPaths("3dtiles", scene).ok());
  return scene;
}

TEST(PlaceDeliveryTest, CellsMeetAtTheirBorderAndLieInTheirHeight) {
  const auto places = PlaceDelivery(TwoCells());
  ASSERT_TRUE(places.ok()) << places.status();
  ASSERT_TRUE(places->root);
  const Eigen::Matrix4d &a = places->cells.at({0, 0}), &b = places->cells.at({1, 0});
  for (const double y : {0.0, 125.0, 250.0}) {
    EXPECT_LT((Moved(a, Point3(250, y, 7)) - Moved(b, Point3(250, y, 7))).norm(), 0.005) << y;
  }
  const Point3 middle = GeodeticOf(Moved(a, Point3(125, 125, 7)));
  EXPECT_NEAR(middle.z(), 107, 1e-6);
  // By PROJ: EPSG:25832 (600125, 5538755) is 10.4004 E, 49.9939 N.
  EXPECT_NEAR(middle.x() * 180 / M_PI, 10.398, 0.005);
  EXPECT_NEAR(GeodeticOf(Moved(a, Point3(0, 0, 0))).z(), 100.0025, 0.001)
      << "the plane touches the Earth in its middle";
}

TEST(PlaceDeliveryTest, ASceneWithoutACrsIsNotOnTheEarth) {
  Scene scene = TwoCells();
  scene.crs.clear();
  const auto places = PlaceDelivery(scene);
  ASSERT_TRUE(places.ok()) << places.status();
  EXPECT_FALSE(places->root);
  EXPECT_TRUE(places->cells.at({1, 0}).isIdentity(0));
  EXPECT_THAT(places->warning, testing::HasSubstr("names no CRS"));
}

TEST(PlaceDeliveryTest, OtherFormatsHaveNoPlaces) {
  Scene scene = TwoCells();
  ASSERT_TRUE(SetDeliveryPaths("obj", scene).ok());
  EXPECT_TRUE(PlaceDelivery(scene)->cells.empty());
}

TEST(DeliveryEntryTest, WithoutATileThereIsNone) {
  const Scene scene = TwoCells();
  EXPECT_FALSE(DeliveryEntry(scene, *PlaceDelivery(scene), "/no/such/folder").ok());
}

}  // namespace
}  // namespace tilemend
