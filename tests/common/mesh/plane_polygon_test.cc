#include "common/mesh/plane_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tilemend {
namespace {

std::vector<Point2> Square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }

TEST(PlanePolygonTest, WithoutRingsNothingIsInside) {
  EXPECT_TRUE(PlanePolygon().empty());
  EXPECT_FALSE(Contains({}, {0, 0}));
}

TEST(PlanePolygonTest, RingsWithinRingsAreHolesWhateverTheirDirection) {
  PlanePolygon polygon{{Square(0, 9), Square(2, 7), Square(4, 5)}};
  for (int turn = 0; turn < 2; ++turn) {
    EXPECT_FALSE(Contains(polygon, {-1, 4.5}));
    EXPECT_TRUE(Contains(polygon, {1, 4.5}));
    EXPECT_FALSE(Contains(polygon, {3, 4.5}));
    EXPECT_TRUE(Contains(polygon, {4.5, 4.5})) << "an island in the hole";
    EXPECT_FALSE(Contains(polygon, {4.5, 10}));
    std::reverse(polygon.rings[1].begin(), polygon.rings[1].end());
  }
}

TEST(PlanePolygonTest, TheAreaIsThatInside) {
  EXPECT_EQ(AreaOf({}), 0);
  EXPECT_DOUBLE_EQ(AreaOf({{Square(0, 9), Square(2, 7), Square(4, 5)}}), 81 - 25 + 1);
  EXPECT_DOUBLE_EQ(AreaOf({{Square(0, 1), Square(5, 7)}}), 5);
}

TEST(PlanePolygonTest, ALineThroughACornerCountsItOnce) {
  const PlanePolygon diamond{{{{0, -2}, {2, 0}, {0, 2}, {-2, 0}}}};
  EXPECT_TRUE(Contains(diamond, {0, 0})) << "the line to the right runs through the corner (2, 0)";
  EXPECT_FALSE(Contains(diamond, {-3, 0}));
  EXPECT_FALSE(Contains(diamond, {-1, 2}));
}

}  // namespace
}  // namespace tilemend
