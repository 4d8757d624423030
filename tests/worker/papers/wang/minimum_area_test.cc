#include "worker/papers/wang/minimum_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

const auto kAnyChord = [](int32_t, int32_t) { return true; };
const auto kAnyTriangle = [](int32_t, int32_t, int32_t) { return true; };

TEST(TriangulateLeastAreaTest, EndsWithoutAResultOnceItIsCancelled) {
  const std::vector<Point3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(TriangulateLeastArea(square, kAnyChord, kAnyTriangle, [] { return false; }).size(), 2U);
  EXPECT_TRUE(TriangulateLeastArea(square, kAnyChord, kAnyTriangle, [] { return true; }).empty());
}

double AreaOf(const std::vector<Point3>& loop, const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) area += TriangleArea(loop[t[0]], loop[t[1]], loop[t[2]]);
  return area;
}

// Of all triangulations of the places i to k.
double LeastArea(const std::vector<Point3>& loop, int32_t i, int32_t k) {
  if (k - i < 2) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (int32_t j = i + 1; j < k; ++j) {
    least = std::min(least, LeastArea(loop, i, j) + LeastArea(loop, j, k) + TriangleArea(loop[i], loop[j], loop[k]));
  }
  return least;
}

std::vector<Point3> Crown(int n) {
  std::vector<Point3> loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    loop.emplace_back((3 + i % 3) * std::cos(angle), 4 * std::sin(angle), 2 * std::cos(3 * angle + i));
  }
  return loop;
}

TEST(TriangulateLeastAreaTest, FindsTheLeastOfAllTriangulations) {
  for (const int n : {3, 4, 7, 10}) {
    const std::vector<Point3> loop = Crown(n);
    const std::vector<Triangle> triangles = TriangulateLeastArea(loop, kAnyChord, kAnyTriangle);
    ASSERT_EQ(triangles.size(), loop.size() - 2);
    EXPECT_NEAR(AreaOf(loop, triangles), LeastArea(loop, 0, n - 1), 1e-9);
  }
}

TEST(TriangulateLeastAreaTest, TakesTheDiagonalWithLessArea) {
  const std::vector<Point3> saddle = {{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1.2}};
  const std::vector<Triangle> free = TriangulateLeastArea(saddle, kAnyChord, kAnyTriangle);
  const std::vector<Triangle> other = TriangulateLeastArea(
      saddle, [](int32_t i, int32_t k) { return i != 0 || k != 2; }, kAnyTriangle);
  const std::vector<Triangle> first = TriangulateLeastArea(
      saddle, [](int32_t i, int32_t k) { return i == 0 && k == 2; }, kAnyTriangle);
  EXPECT_NEAR(AreaOf(saddle, free), std::min(AreaOf(saddle, other), AreaOf(saddle, first)), 1e-12);
  EXPECT_NE(AreaOf(saddle, other), AreaOf(saddle, first));
}

TEST(TriangulateLeastAreaTest, MakesNoTriangleThatDoesNotFit) {
  const std::vector<Point3> loop = Crown(8);
  const auto fits = [](int32_t i, int32_t j, int32_t k) { return i == 0 || j == k - 1; };
  for (const Triangle& t : TriangulateLeastArea(loop, kAnyChord, fits)) EXPECT_TRUE(fits(t[0], t[1], t[2]));
  EXPECT_TRUE(TriangulateLeastArea(loop, kAnyChord, [](int32_t, int32_t, int32_t) { return false; }).empty());
}

TEST(TriangulateLeastAreaTest, RefusesWhatHasNoArea) {
  EXPECT_TRUE(TriangulateLeastArea(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}}, kAnyChord, kAnyTriangle).empty());
  EXPECT_TRUE(
      TriangulateLeastArea(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, kAnyChord, kAnyTriangle).empty());
}

}  // namespace
}  // namespace tilemend
