#include "coordinator/waves/clearing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

const Grid kGrid{{0, 0}, {10, 10}};
const std::vector<CellId> kCells{{0, 0}, {1, 0}, {2, 0}, {3, 0}};

PlanePolygon Rectangle(double x0, double x1) { return {{{{x0, 1}, {x1, 1}, {x1, 9}, {x0, 9}}}}; }

// Water over cells (0, 0) and (1, 0) that is measured, water in cell (3, 0) with a level, and ground in cell (1, 0).
std::vector<WaterArea> Areas() {
  std::vector<WaterArea> areas(4);
  areas[0].label = "only told";
  areas[1] = {true, Rectangle(5, 15), std::nullopt, {}, "pond", WaterKind::kUnsaid, true, 1.5};
  areas[2] = {true, Rectangle(33, 37), 7.0, {}, "basin", WaterKind::kUnsaid, true, 0.5};
  areas[3] = {false, Rectangle(13, 17), std::nullopt, {}, "cars", WaterKind::kUnsaid, true, 1.5};
  return areas;
}

class ClearingTest : public ::testing::Test {
 protected:
  std::vector<WaterArea> areas_ = Areas();
  Clearing clearing_{areas_, kGrid, kCells};
};

TEST_F(ClearingTest, MeasuresWaterWithoutALevelInTilesThatReachIt) {
  EXPECT_THAT(clearing_.Polygons({0, 0}), SizeIs(1));
  EXPECT_THAT(clearing_.Polygons({1, 0}), SizeIs(1));
  EXPECT_THAT(clearing_.Polygons({2, 0}), IsEmpty()) << "a tile reaches a quarter cell beyond its cell: to 17.5";
  EXPECT_THAT(clearing_.Polygons({3, 0}), IsEmpty());
}

TEST_F(ClearingTest, AllTilesTogetherTellOneLevel) {
  ASSERT_TRUE(clearing_.TakeTallies({1, 0}, std::vector<HeightTally>{{{{3072, 5'000'000}, {3082, 90'000'000}}}}).ok());
  ASSERT_TRUE(clearing_.TakeTallies({0, 0}, std::vector<HeightTally>{{{{3082, 50'000'000}, {9216, 8'000'000}}}}).ok());
  clearing_.Settle(areas_);
  ASSERT_TRUE(areas_[1].level);
  EXPECT_EQ(*areas_[1].level, 3082 * kHeightBin);
  EXPECT_EQ(areas_[1].level_sigma, 0);
  EXPECT_FALSE(areas_[1].is_mostly_open);
  EXPECT_FALSE(areas_[0].level || areas_[3].level);
  ASSERT_THAT(clearing_.Areas({0, 0}), SizeIs(1));
  EXPECT_EQ(clearing_.Areas({0, 0})[0].top, 3082 * kHeightBin + 1.5);
  ASSERT_THAT(clearing_.Areas({1, 0}), SizeIs(2));
  EXPECT_EQ(clearing_.Areas({1, 0})[1].top, std::numeric_limits<double>::infinity());
  ASSERT_THAT(clearing_.Areas({3, 0}), SizeIs(1));
  EXPECT_EQ(clearing_.Areas({3, 0})[0].top, 7.5);
}

// Of 80 m2 only 15 are there, say at the banks of a hole.
TEST_F(ClearingTest, LittleSurfaceIsTakenOutAndTellsNoLevel) {
  ASSERT_TRUE(clearing_.TakeTallies({0, 0}, std::vector<HeightTally>{{{{4096, 6'000'000}, {9216, 9'000'000}}}}).ok());
  clearing_.Settle(areas_);
  EXPECT_FALSE(areas_[1].level);
  ASSERT_THAT(clearing_.Areas({0, 0}), SizeIs(1));
  EXPECT_EQ(clearing_.Areas({0, 0})[0].top, 5.5);
  EXPECT_TRUE(areas_[1].is_mostly_open);
  EXPECT_FALSE(areas_[2].is_mostly_open);
}

// The polygon goes 45 m beyond the scene. Of the 40 m2 in its cells all but 4 are there.
TEST(ClearingBeyondTheSceneTest, OnlyWhatLiesInCellsOfTheSceneIsExpected) {
  std::vector<WaterArea> areas = Areas();
  areas[1].polygon = Rectangle(5, 60);
  for (const std::vector<CellId>& cells : {std::vector<CellId>{{0, 0}}, kCells}) {
    Clearing clearing(areas, kGrid, cells);
    EXPECT_TRUE(clearing.IsMeasured({0, 0}));
    ASSERT_TRUE(clearing.TakeTallies({0, 0}, std::vector<HeightTally>{{{{3072, 36'000'000}}}}).ok());
    std::vector<WaterArea> settled = areas;
    clearing.Settle(settled);
    EXPECT_EQ(settled[1].is_mostly_open, cells.size() > 1) << "cells without a tile are open";
    EXPECT_EQ(settled[1].level.has_value(), cells.size() == 1);
  }
}

TEST_F(ClearingTest, WaterWithoutSurfaceInItHasNoLevelAndTakesNothing) {
  clearing_.Settle(areas_);
  EXPECT_FALSE(areas_[1].level);
  EXPECT_THAT(clearing_.Areas({0, 0}), IsEmpty());
}

TEST_F(ClearingTest, CountsByAreaAndTile) {
  clearing_.Settle(areas_);
  ASSERT_TRUE(clearing_.TakeCounts({1, 0}, std::vector<int64_t>{4}).ok());
  ASSERT_TRUE(clearing_.TakeCounts({3, 0}, std::vector<int64_t>{0}).ok());
  const std::vector<ClearedArea> cleared = clearing_.Cleared();
  ASSERT_THAT(cleared, SizeIs(3));
  EXPECT_THAT(cleared[2].triangles_of, ElementsAre(Pair(CellId{1, 0}, 4)));
  EXPECT_THAT(cleared[1].triangles_of, IsEmpty());
  EXPECT_EQ(cleared[1].top, 7.5);
  EXPECT_EQ(cleared[2].top, std::nullopt);
  EXPECT_THAT(clearing_.Areas({3, 0}), IsEmpty()) << "nothing was there, so the tile is the file as it is";
  EXPECT_THAT(clearing_.Areas({1, 0}), SizeIs(1));
}

TEST_F(ClearingTest, RefusesResultsOfOtherAreas) {
  EXPECT_FALSE(clearing_.TakeTallies({0, 0}, {}).ok());
  clearing_.Settle(areas_);
  EXPECT_FALSE(clearing_.TakeCounts({1, 0}, {}).ok());
  EXPECT_FALSE(clearing_.TakeCounts({1, 0}, std::vector<int64_t>{-1}).ok());
}

TEST(ClearingInAnAreaTest, TheOutlineNearATileGoesWithIt) {
  Clearing clearing(Areas(), kGrid, kCells, Rectangle(-100, 38));
  std::vector<WaterArea> areas = Areas();
  clearing.Settle(areas);
  ASSERT_THAT(clearing.Areas({3, 0}), SizeIs(1));
  EXPECT_THAT(clearing.Areas({3, 0})[0].outline, SizeIs(3)) << "below, above, and to the east";
  ASSERT_THAT(clearing.Areas({1, 0}), SizeIs(1));
  EXPECT_THAT(clearing.Areas({1, 0})[0].outline, SizeIs(2));
}

TEST(ClearingOfAMeshTest, AllAreasReachTheOneTile) {
  const Clearing clearing(Areas(), Grid(), {});
  EXPECT_THAT(clearing.Polygons({0, 0}), SizeIs(1));
  EXPECT_THAT(clearing.Areas({0, 0}), SizeIs(2));
}

}  // namespace
}  // namespace tilemend
