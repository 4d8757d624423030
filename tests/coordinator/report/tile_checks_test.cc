#include "coordinator/report/tile_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/grid/tile_hulls.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/tileset_scene.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// Cell (2, 1) of a grid of 10 m from (100, 200): x 120 to 130, y 210 to 220.
class CheckInsideCellTest : public ::testing::Test {
 protected:
  CheckInsideCellTest() {
    scene_.root = "/scene";
    scene_.grid = {{100, 200}, {10, 10}};
  }
  absl::Status Check(double x0, double x1, double y0, double y1) const {
    SurveyRecord record;
    record.lo = {x0, y0, -1e6};
    record.hi = {x1, y1, 1e6};
    return CheckInsideCell(record, scene_, {{2, 1}, "tiles/a.ply"});
  }
  Scene scene_;
};

TEST_F(CheckInsideCellTest, TakesATileInItsCellAtAnyHeight) { EXPECT_TRUE(Check(120, 130, 210, 220).ok()); }

TEST_F(CheckInsideCellTest, TakesATileThatReachesAQuarterCellBeyond) {
  EXPECT_TRUE(Check(117.5, 132.5, 207.5, 222.5).ok());
}

TEST_F(CheckInsideCellTest, RefusesATileBeyondThatOnAnySide) {
  EXPECT_FALSE(Check(117.4, 130, 210, 220).ok());
  EXPECT_FALSE(Check(120, 132.6, 210, 220).ok());
  EXPECT_FALSE(Check(120, 130, 207.4, 220).ok());
  EXPECT_FALSE(Check(120, 130, 210, 222.6).ok());
}

TEST_F(CheckInsideCellTest, NamesTheFileAndBothExtents) {
  const absl::Status status = Check(0, 1, 210, 220);
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("/scene/tiles/a.ply: outside its cell +002_+001: the tile spans x 0 to 1, y 210 to 220, the "
                        "cell x 120 to 130, y 210 to 220"));
}

TEST(ReadTileHullTest, GivesTheOutermostVertices) {
  const TemporaryFolder folder;
  const auto hull =
      ReadTileHull(folder.Write("a.obj", "v 3 0 -2\nv 1 5 0\nv 2 3 7\nv 2.5 3 7\nf 1 2 3\nf 1 3 4\n"), {});
  ASSERT_TRUE(hull.ok()) << hull.status();
  EXPECT_THAT(*hull, testing::ElementsAre(Point2(1, 5), Point2(3, 0), Point2(2.5, 3)));
}

TEST(ReadTilesetsTest, GivesTheTilesetsInTheFrameOfTheScene) {
  const TemporaryFolder folder;
  const TilesetScene scene{.files = TilesetScene::Files::kOfTiles, .place = TilesetScene::Place::kEarthCentred};
  for (const auto& [path, bytes] : scene.All()) folder.Write(path, bytes);
  const auto tilesets = ReadTilesets(folder.path(), "tileset.json", 0);
  ASSERT_TRUE(tilesets.ok()) << tilesets.status();
  ASSERT_EQ(tilesets->tiles.size(), 2U);
  EXPECT_EQ(tilesets->tiles[1].path, "Data/Tile_p001_p000/Tile_p001_p000.json");
  EXPECT_EQ(tilesets->tiles[1].frame.size(), 16U);
  // The middle of the scene is the origin.
  const auto bounds = [&](const TilesetTiles& of, int tile, double turn) {
    return BoundsOf(ReadTileHull(folder / of.tiles[tile].path, of.tiles[tile].frame).value(), turn);
  };
  EXPECT_NEAR(bounds(*tilesets, 0, 0).lo.x(), -64.5, 0.01);
  EXPECT_NEAR(bounds(*tilesets, 1, 0).hi.y(), 32.5, 0.01);
  const auto turned = ReadTilesets(folder.path(), "tileset.json", 0.2);
  ASSERT_TRUE(turned.ok()) << turned.status();
  EXPECT_NEAR(bounds(*turned, 0, 0).lo.x(), bounds(*tilesets, 0, 0.2).lo.x(), 1e-6);
  EXPECT_NEAR(bounds(*turned, 1, 0).hi.y(), bounds(*tilesets, 1, 0.2).hi.y(), 1e-6);
  EXPECT_TRUE(absl::IsNotFound(ReadTilesets(folder.path(), "none.json", 0).status()));
}

TEST(ReadTileHullTest, NamesAFileThatIsNotThere) {
  const TemporaryFolder folder;
  const absl::Status status = ReadTileHull(folder / "none.ply", {}).status();
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("none.ply"));
}

}  // namespace
}  // namespace tilemend
