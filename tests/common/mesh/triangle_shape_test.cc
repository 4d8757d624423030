#include "common/mesh/triangle_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

std::vector<SpaceTriangle> RandomTriangles() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-10, 10);
  std::vector<SpaceTriangle> triangles(50);
  for (SpaceTriangle& t : triangles) {
    for (Point3& p : t) p = Point3(place(random), place(random), place(random));
  }
  return triangles;
}

TEST(TwiceVectorAreaTest, PointsToWhereTheTriangleIsSeenCounterClockwise) {
  EXPECT_EQ(TwiceVectorArea({0, 0, 5}, {3, 0, 5}, {0, 4, 5}), Eigen::Vector3d(0, 0, 12));
  EXPECT_EQ(TwiceVectorArea({0, 0, 5}, {0, 4, 5}, {3, 0, 5}), Eigen::Vector3d(0, 0, -12));
  EXPECT_EQ(TriangleArea({0, 0, 5}, {3, 0, 5}, {0, 4, 5}), 6);
  EXPECT_EQ(TriangleArea({1, 1, 1}, {2, 2, 2}, {3, 3, 3}), 0);
}

TEST(TwiceVectorAreaTest, IsTheSameForEveryFormOfATriangle) {
  for (const SpaceTriangle& t : RandomTriangles()) {
    const std::vector<Point3> points = {t[2], t[0], t[1]};
    EXPECT_EQ(TwiceVectorArea(t), TwiceVectorArea(t[0], t[1], t[2]));
    EXPECT_EQ(TwiceVectorArea(t), TwiceVectorArea(points, {1, 2, 0}));
  }
}

TEST(TriangleQualityTest, KnownTriangles) {
  EXPECT_NEAR(TriangleQuality({0, 0, 0}, {2, 0, 0}, {1, 0, std::sqrt(3.0)}), 1, 1e-12);
  // Legs 3 and 4: r = 1, R = 2.5.
  EXPECT_NEAR(TriangleQuality({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 0.8, 1e-12);
  EXPECT_EQ(TriangleQuality({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_EQ(TriangleQuality({1, 1, 1}, {1, 1, 1}, {1, 1, 1}), 0);
}

TEST(TriangleShapeTest, KnownTriangles) {
  EXPECT_NEAR(TriangleShape({0, 0, 0}, {2, 0, 0}, {1, 0, std::sqrt(3.0)}), 1, 1e-12);
  // Area 6, squared edges 9, 16 and 25.
  EXPECT_NEAR(TriangleShape({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 24 * std::sqrt(3.0) / 50, 1e-12);
  EXPECT_EQ(TriangleShape({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_TRUE(std::isnan(TriangleShape({1, 1, 1}, {1, 1, 1}, {1, 1, 1})));
  EXPECT_LT(TriangleShape(-12, 50), 0);
}

TEST(TriangleShapeTest, IsThatOfTheTriangleHoweverItIsTurnedScaledOrNumbered) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  for (const SpaceTriangle& t : RandomTriangles()) {
    SpaceTriangle other = {t[1], t[2], t[0]};
    for (Point3& p : other) p = 1000 * (turn * p) + Point3(5e4, -2e4, 300);
    EXPECT_NEAR(TriangleShape(other[0], other[1], other[2]), TriangleShape(t[0], t[1], t[2]), 1e-9);
    EXPECT_NEAR(TriangleQuality(other[0], other[1], other[2]), TriangleQuality(t[0], t[1], t[2]), 1e-9);
  }
}

TEST(TriangleShapeTest, LiesBetweenZeroAndOneAsQualityDoes) {
  for (const SpaceTriangle& t : RandomTriangles()) {
    for (const double value : {TriangleShape(t[0], t[1], t[2]), TriangleQuality(t[0], t[1], t[2])}) {
      EXPECT_GT(value, 0);
      EXPECT_LT(value, 1);
    }
  }
}

}  // namespace
}  // namespace tilemend
