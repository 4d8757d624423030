#include "common/codec/tiles3d/tileset_frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "common/codec/tiles3d/bounding_volume.h"
#include "tests/support/tileset_samples.h"
#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

Tileset TilesetOf(const TilesetScene& scene) { return ReadTileset(MemorySource(scene.All()), "tileset.json").value(); }

TEST(TilesetFrameTest, WithoutAPlaceOnTheEarthNothingIsTurned) {
  const Tileset tileset = TilesetOf({});
  const TilesetFrame frame = FrameOf(tileset);
  EXPECT_EQ(ToScene(frame, tileset.tiles.back()), Eigen::Matrix4d::Identity());
  EXPECT_EQ(frame.crs, "");
}

TEST(TilesetFrameTest, ARootOnTheEarthGivesItsOwnFrameToTheBit) {
  const Tileset tileset = TilesetOf({.place = TilesetScene::Place::kOnEarth});
  const TilesetFrame frame = FrameOf(tileset);
  EXPECT_TRUE(frame.is_roots);
  EXPECT_EQ(ToScene(frame, tileset.tiles.back()), Eigen::Matrix4d::Identity());
  EXPECT_THAT(frame.crs, HasSubstr("+proj=ortho +lat_0=50 +lon_0=8 "));
  const Point3 origin = tileset.tiles[0].to_root.topRightCorner<3, 1>();
  EXPECT_EQ(frame.height, GeodeticOf(origin).z());
}

TEST(TilesetFrameTest, ARootTurnedAboutTheVerticalHasACrsThatIsTurned) {
  Tileset tileset = TilesetOf({.place = TilesetScene::Place::kOnEarth});
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.3, Point3::UnitZ()).matrix();
  tileset.tiles[0].to_root = tileset.tiles[0].to_root * turn;
  EXPECT_TRUE(FrameOf(tileset).is_roots);
  EXPECT_THAT(FrameOf(tileset).crs, HasSubstr("+proj=omerc +lat_0=50 +lonc=8 +alpha=45 +gamma=62.188733"));
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.3, Point3::UnitX()).matrix();
  tileset.tiles[0].to_root = tileset.tiles[0].to_root * turn;
  EXPECT_FALSE(FrameOf(tileset).is_roots) << "z is not up";
}

TEST(TilesetFrameTest, EarthCentredTilesAreTurnedUpright) {
  const Tileset tileset = TilesetOf({.place = TilesetScene::Place::kEarthCentred});
  const TilesetFrame frame = FrameOf(tileset);
  EXPECT_FALSE(frame.is_roots);
  // The middle of the root's volume is the origin.
  EXPECT_NEAR(Moved(ToScene(frame, tileset.tiles.back()), {64, 32, 2}).norm(), 0, 1e-8);
  const Point3 up = Moved(ToScene(frame, tileset.tiles.back()), {64, 32, 3});
  EXPECT_NEAR((up - Point3(0, 0, 1)).norm(), 0, 1e-4);
  const Point3 east = Moved(ToScene(frame, tileset.tiles.back()), {65, 32, 2});
  EXPECT_NEAR((east - Point3(1, 0, 0)).norm(), 0, 1e-4);
  EXPECT_THAT(frame.crs, HasSubstr("+lat_0=50.000"));
}

TEST(TilesetFrameTest, AxesAreTurned) {
  for (const auto place :
       {TilesetScene::Place::kLocal, TilesetScene::Place::kOnEarth, TilesetScene::Place::kEarthCentred}) {
    const Tileset tileset = TilesetOf({.place = place});
    Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
    turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(-0.3, Point3::UnitZ()).matrix();
    const Eigen::Matrix4d expected = turn * ToScene(FrameOf(tileset), tileset.tiles.back());
    EXPECT_LT((ToScene(FrameOf(tileset, 0.3), tileset.tiles.back()) - expected).norm(), 1e-8);
  }
}

TEST(TilesetFrameTest, ARegionLiesOnTheEarth) {
  Tileset tileset = TilesetOf({});
  tileset.tiles[0].volume = {BoundingVolume::Kind::kRegion, {3.14, 0.5, -3.14, 0.6, 100, 300}};
  const TilesetFrame frame = FrameOf(tileset);
  EXPECT_THAT(frame.crs, HasSubstr("+lat_0=31.512")) << frame.crs;
  EXPECT_THAT(frame.crs, HasSubstr("+lon_0=180 ")) << frame.crs;
}

}  // namespace
}  // namespace tilemend
