#include "common/grid/tile_hulls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <vector>

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ConvexHull Square(const Point2& lo, double side, double turn = 0) {
  ConvexHull hull;
  for (const Point2& p : {Point2(0, 0), Point2(side, 0), Point2(side, side), Point2(0, side)}) {
    hull.emplace_back(Eigen::Rotation2Dd(turn) * (lo + p));
  }
  return hull;
}

TEST(HullOfTest, HasEachCornerOnce) {
  EXPECT_THAT(HullOf({{4, 0}, {0, 0}, {2, 0}, {4, 4}, {1, 2}, {0, 4}, {4, 0}, {4, 1}}),
              ElementsAre(Point2(0, 0), Point2(4, 0), Point2(4, 4), Point2(0, 4)));
}

TEST(HullOfTest, OfALineHasItsEnds) {
  EXPECT_THAT(HullOf({{1, 1}, {3, 3}, {2, 2}}), ElementsAre(Point2(1, 1), Point2(3, 3)));
  EXPECT_THAT(HullOf({{1, 1}, {1, 1}}), ElementsAre(Point2(1, 1)));
  EXPECT_THAT(HullOf({}), IsEmpty());
}

TEST(BoundsOfTest, AreAlongTurnedAxes) {
  const Box box = BoundsOf(Square({3, 5}, 10, 0.3), 0.3);
  EXPECT_NEAR((box.lo - Point3(3, 5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((box.hi - Point3(13, 15, 0)).norm(), 0, 1e-12);
}

TEST(TilesToLookAtTest, AreAllOfFew) { EXPECT_THAT(TilesToLookAt({{5, 1}, {0, 0}}), ElementsAre(0U, 1U)); }

TEST(TilesToLookAtTest, TellTheGridAlongBothAxes) {
  for (const auto& [cols, rows] : std::map<int, int>{{1, 5000}, {5000, 1}, {7, 70}, {100, 100}, {3, 9}}) {
    std::vector<CellId> cells;
    for (int i = cols * rows - 1; i >= 0; --i) cells.push_back({i % cols, i / cols});
    const std::vector<size_t> chosen = TilesToLookAt(cells);
    EXPECT_LE(chosen.size(), kMostLookedAt);
    std::set<int> of_cols, of_rows;
    for (const size_t t : chosen) {
      of_cols.insert(cells[t].col);
      of_rows.insert(cells[t].row);
    }
    EXPECT_EQ(*of_cols.rbegin(), cols - 1) << cols << " x " << rows;
    EXPECT_EQ(*of_rows.rbegin(), rows - 1);
    EXPECT_GE(of_cols.size(), std::min(3, cols));
    EXPECT_GE(of_rows.size(), std::min(3, rows));
  }
}

TEST(TurnOfSidesTest, IsThatOfMostTiles) {
  const ConvexHull round = [] {
    ConvexHull hull;
    for (int k = 0; k < 40; ++k) hull.emplace_back(Eigen::Rotation2Dd(k * std::numbers::pi / 20) * Point2(9, 0));
    return hull;
  }();
  EXPECT_NEAR(TurnOfSides({Square({0, 0}, 9, 0.02), Square({9, 0}, 9, 0.02), Square({0, 9}, 9), round}), 0.02, 1e-9);
  EXPECT_EQ(TurnOfSides({round}), 0);
  EXPECT_EQ(TurnOfSides({Square({0, 0}, 9, 0.9 * kLeastGridTurn)}), 0) << "rounding";
  EXPECT_EQ(TurnOfSides({}), 0);
}

TEST(MedianGapTest, IsLeastAlongTheAxesOfTheCut) {
  std::vector<TileHull> tiles;
  for (int i = 0; i < 9; ++i) tiles.push_back({{i % 3, i / 3}, Square({100. * (i % 3), 100. * (i / 3)}, 100.5, 0.1)});
  EXPECT_NEAR(MedianGap(tiles, 0.1), 0.5, 1e-9);
  EXPECT_GT(MedianGap(tiles, 0), 5);
  EXPECT_EQ(MedianGap({tiles[0], tiles[8]}, 0.1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace tilemend
