#include "coordinator/waves/ground_reach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace tilemend {
namespace {

// A tile that reaches over its cell by a margin.
StoredRecord TileOf(CellId cell, double size, double margin) {
  auto record = std::make_shared<SurveyRecord>();
  record->vertex_count = 3;
  record->triangle_count = 1;
  record->lo = Point3(cell.col * size - margin, cell.row * size - margin, 0);
  record->hi = Point3((cell.col + 1) * size + margin, (cell.row + 1) * size + margin, 9);
  return StoredRecord(std::move(record));
}

std::map<CellId, StoredRecord> Tiles(double size) {
  std::map<CellId, StoredRecord> tiles;
  for (int32_t row = 0; row < 5; ++row) {
    for (int32_t col = 0; col < 5; ++col) tiles[{col, row}] = TileOf({col, row}, size, 0.1);
  }
  return tiles;
}

Grid GridOf(double size) { return {Point2(0, 0), Point2(size, size)}; }

TEST(GroundReachTest, OfLargeCellsTheEightAroundCount) {
  EXPECT_EQ(CellsInGroundReach(Tiles(250), GridOf(250), {2, 2}).size(), 9U);
  EXPECT_EQ(CellsInGroundReach(Tiles(250), GridOf(250), {0, 0}).size(), 4U);
}

TEST(GroundReachTest, OfSmallCellsThoseBehindThemToo) {
  EXPECT_EQ(CellsInGroundReach(Tiles(100), GridOf(100), {2, 2}).size(), 25U);
  EXPECT_EQ(CellsInGroundReach(Tiles(50), GridOf(50), {0, 0}).size(), 16U);
}

TEST(GroundReachTest, CellsWithoutSurfaceDoNotCount) {
  std::map<CellId, StoredRecord> tiles = Tiles(250);
  tiles[{1, 2}] = nullptr;
  tiles.erase({3, 3});
  const auto around = CellsInGroundReach(tiles, GridOf(250), {2, 2});
  EXPECT_EQ(around.size(), 7U);
  EXPECT_THAT(around, ::testing::Contains(CellId{2, 2}));
}

TEST(GroundReachTest, OfTinyCellsNothingIsTold) {
  EXPECT_TRUE(IsGroundTold(GridOf(6)));
  EXPECT_FALSE(IsGroundTold(GridOf(5)));
}

}  // namespace
}  // namespace tilemend
