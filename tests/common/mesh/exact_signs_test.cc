#include "common/mesh/exact_signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

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

// The sign of the determinant in whole numbers: exact for coordinates below 2^30.
int SideInIntegers(const std::array<std::array<int64_t, 3>, 4>& p) {
  __int128 m[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[i][k] = p[i + 1][k] - p[0][k];
  }
  const __int128 volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (volume > 0) - (volume < 0);
}

TEST(SideOfPlaneTest, AgreesWithWholeNumbersOnAndNearPlanes) {
  std::mt19937 random(1);
  for (const int32_t range : {2, 1000, 1 << 29}) {
    int on_plane = 0;
    for (int i = 0; i < 3000; ++i) {
      std::array<std::array<int64_t, 3>, 4> whole{};
      for (auto& p : whole) {
        for (int64_t& x : p) x = static_cast<int64_t>(random() % (2u * static_cast<uint32_t>(range) + 1)) - range;
      }
      if (i % 2 == 0) {  // d in the plane of a, b, c, or a step off it
        for (int k = 0; k < 3; ++k) whole[3][k] = whole[1][k] + whole[2][k] - whole[0][k];
        whole[3][0] += i % 6 == 0 ? 1 : 0;
      }
      std::array<Point3, 4> points;
      for (int k = 0; k < 4; ++k) {
        points[k] = Point3(static_cast<double>(whole[k][0]), static_cast<double>(whole[k][1]),
                           static_cast<double>(whole[k][2])) *
                    0x1p-20;
      }
      const int side = SideInIntegers(whole);
      ASSERT_EQ(SideOfPlane(points[0], points[1], points[2], points[3]), side);
      on_plane += side == 0 ? 1 : 0;
    }
    EXPECT_GT(on_plane, 500) << range;
  }
}

TEST(SideOfPlaneTest, ChangesItsSignWithEveryExchange) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1e5, 1e5);
  int off_plane = 0;
  for (int i = 0; i < 100; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = Point3(place(random), place(random), place(random));
    // A fourth point of their plane as well as doubles can say it.
    p[3] = p[0] + 0.3 * (p[1] - p[0]) + 0.4 * (p[2] - p[0]);
    const int side = SideOfPlane(p[0], p[1], p[2], p[3]);
    off_plane += side != 0 ? 1 : 0;
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        std::array<Point3, 4> q = p;
        std::swap(q[a], q[b]);
        EXPECT_EQ(SideOfPlane(q[0], q[1], q[2], q[3]), -side);
      }
    }
  }
  EXPECT_GT(off_plane, 90);
}

TEST(TurnOfTest, IsTheSameFromEveryCornerAndFarFromZero) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const auto whole = [&] { return static_cast<int64_t>(random() % 2001) - 1000; };
    const int64_t ax = whole(), ay = whole(), bx = whole(), by = whole();
    const int64_t cx = i % 2 == 0 ? 3 * bx - 2 * ax : whole(), cy = i % 2 == 0 ? 3 * by - 2 * ay + i % 4 / 2 : whole();
    const int64_t area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    for (const double far : {0.0, 0x1p30}) {
      const auto at = [far](int64_t x, int64_t y) {
        return Point2(far + static_cast<double>(x) * 0x1p-12, static_cast<double>(y) * 0x1p-12 - far);
      };
      const Point2 a = at(ax, ay), b = at(bx, by), c = at(cx, cy);
      const int turn = (area > 0) - (area < 0);
      ASSERT_EQ(TurnOf(a, b, c), turn);
      ASSERT_EQ(TurnOf(b, c, a), turn);
      ASSERT_EQ(TurnOf(c, b, a), -turn);
    }
  }
}

}  // namespace
}  // namespace tilemend
