#include "common/grid/grid_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace tilemend {
namespace {

using testing::HasSubstr;

// Tiles that fill cols x rows cells, from index (first.col, first.row).
std::vector<PlacedTile> Tiles(int cols, int rows, Point2 size, Point2 corner = {0, 0}, CellId first = {0, 0}) {
  std::vector<PlacedTile> tiles;
  for (int r = first.row; r < first.row + rows; ++r) {
    for (int c = first.col; c < first.col + cols; ++c) {
      const Point2 lo = corner + Point2(c, r).cwiseProduct(size);
      tiles.push_back(
          {{c, r}, "Tile_" + ToString({c, r}), {{lo.x(), lo.y(), 0}, {lo.x() + size.x(), lo.y() + size.y(), 9}}});
    }
  }
  return tiles;
}

void ExpectGrid(const std::vector<PlacedTile>& tiles, Point2 size, Point2 corner) {
  const auto grid = FitGrid(tiles);
  ASSERT_TRUE(grid.ok()) << grid.status();
  EXPECT_EQ(grid->cell_size, size);
  EXPECT_EQ(grid->corner, corner);
}

TEST(FitGridTest, FindsExactCells) {
  ExpectGrid(Tiles(4, 3, {250, 250}), {250, 250}, {0, 0});
  ExpectGrid(Tiles(2, 2, {100, 50}, {-30, 12.5}, {-1, 14}), {100, 50}, {-30, 12.5});
}

TEST(FitGridTest, KeepsPitchesThatAreNoRoundNumbers) {
  const auto grid = FitGrid(Tiles(16, 16, {20.196870, 15.118108}, {54.651863, -211.660507}));
  ASSERT_TRUE(grid.ok());
  EXPECT_NEAR(grid->cell_size.x(), 20.196870, 1e-4 / 16);
  EXPECT_NEAR(grid->corner.y(), -211.660507, 1e-4);
}

TEST(FitGridTest, ToleratesOverlap) {
  std::vector<PlacedTile> tiles = Tiles(3, 3, {100, 100});
  for (PlacedTile& tile : tiles) {
    tile.bounds.lo -= Point3(0.1, 0.1, 0);
    tile.bounds.hi += Point3(0.1, 0.1, 0);
  }
  ExpectGrid(tiles, {100, 100}, {0, 0});
}

TEST(FitGridTest, TakesTheCellsOfOneColumnAsSquare) {
  std::vector<PlacedTile> tiles = Tiles(1, 4, {100.2, 100.0}, {0, 0}, {0, 14});
  for (PlacedTile& tile : tiles) {
    tile.bounds.lo -= Point3(0.1, 0.1, 0);
    tile.bounds.hi += Point3(-0.1, 0.1, 0);
  }
  ExpectGrid(tiles, {100, 100}, {0, 0});
  EXPECT_FALSE(std::signbit(FitGrid(tiles)->corner.y()));
  ExpectGrid(Tiles(1, 4, {60, 100}), {60, 100}, {0, 0});
}

TEST(FitGridTest, ToleratesZigzagBordersAndHolesAtBorders) {
  std::mt19937 random(7);
  std::vector<PlacedTile> tiles = Tiles(6, 5, {250, 250}, {1000, 2000});
  const auto jitter = [&random] { return random() / 4294967296.0 * 1.5 - 0.5; };
  for (size_t i = 0; i < tiles.size(); ++i) {
    tiles[i].bounds.lo -= Point3(jitter(), jitter(), 0);
    tiles[i].bounds.hi += Point3(jitter(), jitter(), 0);
    if (i % 4 == 0) tiles[i].bounds.lo.x() += 90;
    if (i % 5 == 0) tiles[i].bounds.hi.y() -= 70;
  }
  ExpectGrid(tiles, {250, 250}, {1000, 2000});
}

TEST(FitGridTest, TakesASingleTileAsItsCell) { ExpectGrid(Tiles(1, 1, {80, 60}, {5, 7}, {3, 2}), {80, 60}, {5, 7}); }

TEST(FitGridTest, DoesNotDependOnTheOrder) {
  std::vector<PlacedTile> tiles = Tiles(5, 4, {33.3, 44.4}, {0.7, 0.9});
  for (size_t i = 0; i < tiles.size(); ++i) tiles[i].bounds.lo.x() += 0.01 * static_cast<double>(i % 3);
  const Grid grid = FitGrid(tiles).value();
  std::reverse(tiles.begin(), tiles.end());
  const Grid other = FitGrid(tiles).value();
  EXPECT_EQ(grid.cell_size, other.cell_size);
  EXPECT_EQ(grid.corner, other.corner);
}

TEST(FitGridTest, NamesTheTileThatContradictsTheOthers) {
  std::vector<PlacedTile> tiles = Tiles(3, 3, {100, 100});
  tiles[4].bounds.lo.x() += 1000;
  tiles[4].bounds.hi.x() += 1000;
  const absl::Status status = FitGrid(tiles).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr("Tile_+001_+001: reaches more than a quarter of a cell beyond cell +001_+001"));
}

TEST(FitGridTest, TakesACellAsSquareForASurveyThatLiesAskew) {
  std::vector<PlacedTile> tiles = Tiles(1, 4, {30, 100});
  for (PlacedTile& tile : tiles) tile.bounds.hi.x() += tile.cell.row % 2;  // a ragged cut
  ExpectGrid(tiles, {30.5, 100}, {0, 0});
  for (PlacedTile& tile : tiles) {
    tile.bounds.lo.x() += 20 * tile.cell.row;
    tile.bounds.hi.x() += 20 * tile.cell.row;
  }
  const auto grid = FitGrid(tiles);
  ASSERT_TRUE(grid.ok()) << grid.status();
  EXPECT_EQ(grid->cell_size, Point2(100, 100));
}

TEST(FitGridTest, TakesATileThatHasLittleMoreThanItsOverlap) {
  std::vector<PlacedTile> tiles = Tiles(4, 4, {100, 100});
  for (PlacedTile& tile : tiles) {
    tile.bounds.lo -= Point3(0.5, 0.5, 0);
    tile.bounds.hi += Point3(0.5, 0.5, 0);
  }
  tiles.back().bounds.hi.x() = 300.2;  // at the edge of the survey
  ExpectGrid(tiles, {100, 100}, {0, 0});
}

TEST(FitGridTest, RefusesIndicesThatRunBackwards) {
  std::vector<PlacedTile> tiles = Tiles(3, 1, {100, 100});
  std::swap(tiles[0].bounds, tiles[2].bounds);
  EXPECT_THAT(std::string(FitGrid(tiles).status().message()), HasSubstr("columns"));
}

TEST(FitGridTest, RefusesTilesWithoutExtent) {
  EXPECT_EQ(FitGrid(Tiles(1, 1, {0, 10})).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace tilemend
