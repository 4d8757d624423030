#include "worker/fill/shape/spaced_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

TEST(SpacedPointsTest, FindsWhatIsNearerThanTheLesserSizeOverSqrt2) {
  SpacedPoints points;
  points.Add({0.99, -7, 3}, 1);
  EXPECT_TRUE(points.HasNear({0.99 + 0.7, -7, 3}, 1));
  EXPECT_FALSE(points.HasNear({0.99 + 0.71, -7, 3}, 1));
  EXPECT_TRUE(points.HasNear({0.99, -7.3, 3}, 0.5));
  EXPECT_FALSE(points.HasNear({0.99, -7.4, 3}, 0.5));
  points.Clear();
  EXPECT_FALSE(points.HasNear({0.99, -7, 3}, 1));
}

TEST(SpacedPointsTest, AgreesWithTheDefinitionOfAnySize) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 0x1p32; };
  for (const double unit : {1e-6, 1.0, 1e5}) {
    SpacedPoints points;
    std::vector<std::pair<Point3, double>> all;
    for (int k = 0; k < 500; ++k) {
      const double x = 8 * number() - 4, y = 8 * number() - 4, z = 8 * number() - 4;
      const Point3 p = unit * Point3(x, y, z);
      const double size = unit * (1 + 0.99 * number());
      bool near = false;
      for (const auto& [q, other] : all) near |= std::sqrt(2.0) * (p - q).norm() < std::min(size, other);
      EXPECT_EQ(points.HasNear(p, size), near);
      points.Add(p, size);
      all.emplace_back(p, size);
    }
  }
}

}  // namespace
}  // namespace tilemend
