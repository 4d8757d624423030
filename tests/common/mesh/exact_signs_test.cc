#include "common/mesh/exact_signs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(ExactSignsTest, TellsTheSidesOfAPlane) {
  const Point3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(SideOfPlane(a, b, c, {0.2, 0.2, 1}), 1);
  EXPECT_EQ(SideOfPlane(a, b, c, {0.2, 0.2, -1}), -1);
  EXPECT_EQ(SideOfPlane(a, b, c, {5, -7, 0}), 0);
}

// Points of the plane x + y = z that doubles hold exactly; a last bit decides. Plain arithmetic gets a part of these
// wrong.
TEST(ExactSignsTest, SeesTheLastBitOfACoordinate) {
  const auto on = [](double x, double y) { return Point3(x, y, x + y); };
  const Point3 a = on(0x1p20 + 0x1p-20, 3), b = on(7, 0x1p20 + 0x1p-21), c = on(-0x1p19, -5.5 - 0x1p-22);
  for (int k = 0; k < 100; ++k) {
    const Point3 d = on(1000.0 + k * 0x1p-18, 17 - k * 0x1p-19);
    EXPECT_EQ(SideOfPlane(a, b, c, d), 0) << k;
    Point3 above = d, below = d;
    above.z() = std::nextafter(d.z(), 1e9);
    below.z() = std::nextafter(d.z(), -1e9);
    const int side = SideOfPlane(a, b, c, above);
    EXPECT_NE(side, 0) << k;
    EXPECT_EQ(SideOfPlane(a, b, c, below), -side) << k;
    EXPECT_EQ(SideOfPlane(b, a, c, above), -side) << k;
    EXPECT_EQ(SideOfPlane(a, b, above, c), -side) << k;
  }
}

TEST(ExactSignsTest, SeesTheTurnOfAlmostStraightPoints) {
  const Point2 a(0.1, 0.1), b(0.3, 0.3);
  EXPECT_EQ(TurnOf(a, b, {0.7, 0.7}), 0);
  EXPECT_EQ(TurnOf(a, b, {0.7, std::nextafter(0.7, 1)}), 1);
  EXPECT_EQ(TurnOf(a, b, {0.7, std::nextafter(0.7, 0)}), -1);
  EXPECT_EQ(TurnOf(a, b, {-12.5, -12.5}), 0);
}

}  // namespace
}  // namespace tilemend
