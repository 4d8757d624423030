#include "common/grid/scene_area.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Two cells of 100 m beside each other, from (0, 0).
Scene TwoCells() {
  Scene scene;
  scene.grid = {{0, 0}, {100, 100}};
  scene.cols = 2;
  scene.rows = 1;
  scene.tiles = {{{0, 0}, "a.ply"}, {{1, 0}, "b.ply"}};
  return scene;
}

PlanePolygon Rectangle(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
}

std::vector<std::string> CellsOf(const Scene& scene) {
  std::vector<std::string> cells;
  for (const SceneTile& tile : scene.tiles) cells.push_back(ToString(tile.cell) + tile.path);
  return cells;
}

TEST(CoverAreaTest, AnAreaWithinTheCellsChangesNoCell) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(10, 10, 190, 90), scene).ok());
  EXPECT_TRUE(scene.area_known);
  EXPECT_THAT(scene.area.rings, SizeIs(1));
  EXPECT_THAT(CellsOf(scene), ElementsAre("+000_+000a.ply", "+001_+000b.ply"));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(CoverAreaTest, SquaresThatItCoversBecomeCells) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(10, 10, 250, 150), scene).ok());
  EXPECT_EQ(scene.cols, 3);
  EXPECT_EQ(scene.rows, 2);
  EXPECT_THAT(CellsOf(scene),
              ElementsAre("+000_+000a.ply", "+001_+000b.ply", "+002_+000", "+000_+001", "+001_+001", "+002_+001"));
}

TEST(CoverAreaTest, WhatItOnlyTouchesStaysOutside) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(-0.2, -0.2, 200.2, 100.2), scene).ok());
  EXPECT_THAT(scene.tiles, SizeIs(2));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("less than 1 % of")));
}

TEST(CoverAreaTest, SaysHowLittleItCovers) {
  for (const double width : {0.0001, 1.9, 2.1}) {
    Scene scene = TwoCells();
    ASSERT_TRUE(CoverArea(Rectangle(50, 0, 50 + width, 100), scene).ok());
    EXPECT_THAT(scene.warnings, SizeIs(width < 2 ? 1 : 0)) << width;
    if (width < 1) {
      EXPECT_THAT(scene.warnings[0], HasSubstr("covers 0.01 m2 of the 20000 m2 of the scene's cells"));
    }
  }
}

TEST(CoverAreaTest, SmallAreasAreSaidAsTheyAre) {
  for (const double side : {1.0, 5.0, 10.0, 14.0}) {
    Scene scene = TwoCells();
    ASSERT_TRUE(CoverArea(Rectangle(41, 53, 41 + side, 53 + side), scene).ok()) << side;
    const std::string square = std::to_string(static_cast<int>(side * side));
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("small: it covers " + square + ".00 m2 of the 20000 m2")))
        << side;
  }
}

TEST(CoverAreaTest, WhatHasNoExtentIsTooSmall) {
  Scene scene = TwoCells();
  const absl::Status status = CoverArea(Rectangle(5, 5, 5, 9), scene);
  EXPECT_THAT(std::string(status.message()), HasSubstr("too small"));
}

TEST(CoverAreaTest, SaysHowMuchLiesInCellsWithoutATile) {
  for (const double beyond : {60.0, 70.0}) {
    Scene scene = TwoCells();
    ASSERT_TRUE(CoverArea(Rectangle(0, 0, 200 + beyond, 100), scene).ok());
    ASSERT_THAT(scene.warnings, SizeIs(beyond < 66 ? 0 : 1)) << beyond;
    if (beyond < 66) continue;
    EXPECT_THAT(scene.warnings[0], HasSubstr("26 % of the area (7000 of 27000 m2) lies in cells that have no tile"));
    EXPECT_THAT(scene.warnings[0], HasSubstr("--propose-area"));
  }
}

TEST(CoverAreaTest, CellsThatTheSceneListsWithoutATileAreMeant) {
  Scene scene = TwoCells();
  scene.tiles[1].path = "";
  ASSERT_TRUE(CoverArea(Rectangle(0, 10, 200, 90), scene).ok());
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(CoverAreaTest, RoundingMakesNoSlivers) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(-1e-9, -1e-9, 200 + 1e-9, 100 + 1e-9), scene).ok());
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(CoverAreaTest, BeyondTheGridsCornerTheNumberingIsShifted) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(-150, 10, 190, 90), scene).ok());
  EXPECT_EQ(scene.grid.corner, Point2(-200, 0));
  EXPECT_EQ(scene.cols, 4);
  EXPECT_THAT(CellsOf(scene), ElementsAre("+000_+000", "+001_+000", "+002_+000a.ply", "+003_+000b.ply"));
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("begins 2 columns west and 0 rows south"), HasSubstr("cells that have no tile")));
}

TEST(CoverAreaTest, FilesOfNewCellsAreNumberedAsThoseOfTheTiles) {
  Scene scene = TwoCells();
  scene.tiles[0].path = "tiles/Tile_+000_+000.ply";
  scene.tiles[1].path = "tiles/Tile_+001_+000.ply";
  ASSERT_TRUE(CoverArea(Rectangle(-90, 0, 200, 100), scene).ok());
  ASSERT_THAT(scene.tiles, SizeIs(3));
  EXPECT_EQ(scene.tiles[0].cell, (CellId{0, 0}));
  EXPECT_EQ(OutputPath(scene.tiles[0]), "tiles/Tile_-001_+000.ply");
  EXPECT_TRUE(scene.tiles[0].added);
  EXPECT_FALSE(scene.tiles[1].added);
}

TEST(CoverAreaTest, AnAreaOfWholeCellsIsTheCells) {
  Scene scene = TwoCells();
  ASSERT_TRUE(CoverArea(Rectangle(-0.3, -0.3, 300, 100.3), scene).ok());
  EXPECT_TRUE(scene.area.empty());
  EXPECT_TRUE(scene.area_known);
  EXPECT_THAT(scene.tiles, SizeIs(3));
  ASSERT_TRUE(CoverArea(Rectangle(0, 0, 290, 100), scene).ok());
  EXPECT_FALSE(scene.area.empty());
}

TEST(CoverAreaTest, AnOpeningOfTheAreaMakesNoCells) {
  Scene scene = TwoCells();
  PlanePolygon frame = Rectangle(0, 0, 500, 500);
  frame.rings.push_back(Rectangle(200, 0, 500, 500).rings[0]);
  ASSERT_TRUE(CoverArea(frame, scene).ok());
  EXPECT_EQ(scene.cols, 2);
  EXPECT_EQ(scene.rows, 5);
  EXPECT_THAT(scene.tiles, SizeIs(10));
}

TEST(CoverAreaTest, ANameThatAnotherTileHasIsRefused) {
  Scene scene = TwoCells();
  scene.tiles[0].path = "tiles/Tile_-001_+000.ply";
  const absl::Status status = CoverArea(Rectangle(-90, 10, 190, 90), scene);
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("tiles/Tile_-001_+000.ply"));
}

TEST(CoverAreaTest, AnAreaOfAnotherPlaceIsRefused) {
  for (const PlanePolygon& area :
       {Rectangle(0, 0, 1e9, 1e9), Rectangle(1e9, 1e9, 1e9 + 1, 1e9 + 1), Rectangle(5, 5, 5, 9)}) {
    Scene scene = TwoCells();
    const absl::Status status = CoverArea(area, scene);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(scene.tiles, SizeIs(2));
  }
}

TEST(CoverAreaTest, AnAreaBesideTheSceneIsRefused) {
  Scene scene = TwoCells();
  const absl::Status status = CoverArea(Rectangle(310, 10, 490, 90), scene);
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("covers no cell of the scene"));
  EXPECT_THAT(scene.tiles, SizeIs(2));
}

TEST(CoverAreaTest, AnAreaThatIsMuchLargerThanTheSceneIsRefused) {
  Scene scene = TwoCells();
  const absl::Status status = CoverArea(Rectangle(0, 0, 50000, 50000), scene);
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("adds 249998 cells without a tile to 2"));
  EXPECT_THAT(scene.tiles, SizeIs(2));
}

}  // namespace
}  // namespace tilemend
