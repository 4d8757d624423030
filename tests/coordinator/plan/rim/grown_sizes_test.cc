#include "coordinator/plan/rim/grown_sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

double BySearchOfAll(const std::vector<GrownSizes::Point>& points, const Point2& p, double growth, double limit) {
  for (const GrownSizes::Point& v : points) limit = std::min(limit, v.size + growth * (v.position - p).norm());
  return limit;
}

// Along a curve that is dense here and there; every seventh point lies where another does.
std::vector<GrownSizes::Point> PointsOnCurve(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> size(0.01, 2);
  std::vector<GrownSizes::Point> points;
  for (int i = 0; i < count; ++i) {
    const double t = i % 7 == 0 ? 0.5 : static_cast<double>(i) / count;
    points.push_back({{100 * t * t * t, 30 * std::sin(20 * t)}, size(random)});
  }
  return points;
}

TEST(GrownSizesTest, GivesTheSameAsASearchOfAllPoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-40, 140);
  for (const int count : {1, 2, 8, 9, 100, 5000}) {
    const std::vector<GrownSizes::Point> points = PointsOnCurve(count);
    const GrownSizes field(points);
    for (int i = 0; i < 100; ++i) {
      const Point2 p(place(random), place(random));
      for (const double growth : {0.0, 0.02, 0.3, 5.0}) {
        EXPECT_EQ(field.At(p, growth, 30), BySearchOfAll(points, p, growth, 30)) << count;
      }
    }
  }
}

TEST(GrownSizesTest, WithoutPointsItIsTheLimit) { EXPECT_EQ(GrownSizes({}).At({1, 2}, 0.3, 7), 7); }

}  // namespace
}  // namespace tilemend
