#include "worker/check/corner_cones.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

// Triangles from the origin to points about it, each with two points of its own.
struct Fan {
  explicit Fan(int32_t size, double width) {
    points.emplace_back(0, 0, 0);
    std::mt19937 random(3);
    std::normal_distribution<double> way;
    const auto direction = [&] { return Point3(way(random), way(random), way(random)).normalized(); };
    for (int32_t i = 0; i < size; ++i) {
      const Point3 middle = direction();
      points.emplace_back(middle + width * direction());
      points.emplace_back(middle + width * direction());
      triangles.push_back({0, 2 * i + 1, 2 * i + 2});
    }
  }

  SpaceTriangle InSpace(int32_t t) const {
    return {points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
  }

  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

TEST(CornerConesTest, PartsNoTrianglesThatCross) {
  for (const double width : {0.1, 0.5, 2.0}) {
    const Fan fan(200, width);
    const CornerCones cones(fan.points, fan.triangles);
    int apart = 0, crossing = 0;
    for (int32_t a = 0; a < 200; ++a) {
      for (int32_t b = a + 1; b < 200; ++b) {
        const bool cross = TrianglesCross(fan.InSpace(a), fan.InSpace(b));
        EXPECT_FALSE(cross && cones.AreApart(a, b)) << width << ": " << a << ", " << b;
        crossing += cross;
        apart += cones.AreApart(a, b);
      }
    }
    EXPECT_GT(crossing, 0);
    EXPECT_GT(apart, width < 1 ? 10'000 : 100) << "of 19,900 pairs";
  }
}

TEST(CornerConesTest, TellsNothingOfFewTrianglesOrWithoutOneCommonVertex) {
  const Fan few(10, 0.01);
  EXPECT_FALSE(CornerCones(few.points, few.triangles).AreApart(0, 1));
  Fan fan(100, 0.01);
  fan.triangles[1] = {3, 4, 5};
  fan.triangles[3] = {0, 1, 7};
  const CornerCones cones(fan.points, fan.triangles);
  EXPECT_FALSE(cones.AreApart(0, 1)) << "no vertex in common";
  EXPECT_FALSE(cones.AreApart(0, 3)) << "an edge in common";
}

}  // namespace
}  // namespace tilemend
