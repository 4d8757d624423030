#include "common/grid/area_shares.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace tilemend {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

constexpr double kRounding = 1e-12;
const Grid kGrid{{100, 200}, {100, 50}};
constexpr Squares kTwoByTwo{{0, 0}, {2, 2}};

std::vector<Point2> Rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double Sum(const std::vector<double>& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

TEST(AreaSharesTest, SmallBoxesHaveTheirArea) {
  for (const double side : {0.001, 1.0, 6.3, 10.0, 14.1}) {
    for (const double y : {200.5, 207.0, 230.0}) {
      const auto shares = SharesOf({{Rectangle(120, y, 120 + side, y + side)}}, kGrid, kTwoByTwo);
      EXPECT_THAT(shares, ElementsAre(DoubleNear(side * side / 5000, kRounding), 0, 0, 0)) << side << " " << y;
    }
  }
}

TEST(AreaSharesTest, ABoxOverACornerOfSquaresIsDivided) {
  const auto shares = SharesOf({{Rectangle(190, 245, 230, 270)}}, kGrid, kTwoByTwo);
  EXPECT_THAT(shares, ElementsAre(DoubleNear(0.01, kRounding), DoubleNear(0.03, kRounding), DoubleNear(0.04, kRounding),
                                  DoubleNear(0.12, kRounding)));
}

TEST(AreaSharesTest, SlantedEdgesAreExactInEachSquare) {
  // The diagonal of all four squares is that of two of them.
  const auto shares = SharesOf({{{{100, 200}, {300, 200}, {300, 300}}}}, kGrid, kTwoByTwo);
  EXPECT_THAT(shares, ElementsAre(DoubleNear(0.5, kRounding), DoubleNear(1, kRounding), 0, DoubleNear(0.5, kRounding)));
  const auto flat = SharesOf({{{{100, 210}, {300, 213}, {120, 219}}}}, kGrid, kTwoByTwo);
  EXPECT_NEAR(Sum(flat) * 5000, 0.5 * (200 * 9 - 20 * 3), 1e-9);
  EXPECT_NEAR(flat[1] * 5000, 0.5 * 100 * (213 + 100.0 / 180 * 6 - 211.5), 1e-9);
}

TEST(AreaSharesTest, RingsInAnyDirectionLeaveOpenings) {
  std::vector<Point2> opening = Rectangle(110, 205, 190, 245);
  for (int turn = 0; turn < 2; ++turn) {
    const auto shares = SharesOf({{Rectangle(100, 200, 300, 300), opening}}, kGrid, kTwoByTwo);
    EXPECT_THAT(shares, ElementsAre(DoubleNear(0.36, kRounding), DoubleNear(1, kRounding), DoubleNear(1, kRounding),
                                    DoubleNear(1, kRounding)));
    opening = {opening.rbegin(), opening.rend()};
  }
}

TEST(AreaSharesTest, OnlyWhatLiesInTheCellsIsTheirArea) {
  const PlanePolygon all{{Rectangle(-1e4, -1e4, 1e4, 1e4)}}, slant{{{{100, 200}, {300, 200}, {300, 300}}}};
  const std::vector<CellId> square{{1, 1}, {0, 0}, {1, 0}, {0, 1}};
  EXPECT_NEAR(AreaInCells(all, kGrid, square), 4 * 5000, 1e-6);
  EXPECT_NEAR(AreaInCells(slant, kGrid, square), 2 * 5000, 1e-6);
  const std::vector<CellId> ragged{{0, 0}, {1, 0}, {1, 1}, {0, 2}, {1, 2}, {99'999, 99'999}};
  EXPECT_NEAR(AreaInCells(all, kGrid, ragged), 5 * 5000, 1e-6);
  EXPECT_NEAR(AreaInCells(slant, kGrid, ragged), 2 * 5000, 1e-6);
  EXPECT_EQ(AreaInCells(all, kGrid, {}), 0);
}

TEST(AreaSharesTest, SquaresMayBeginElsewhere) {
  const auto shares = SharesOf({{Rectangle(0, 100, 100, 125)}}, kGrid, {{-1, -2}, {0, -1}});
  EXPECT_THAT(shares, ElementsAre(DoubleNear(0.5, kRounding)));
}

}  // namespace
}  // namespace tilemend
