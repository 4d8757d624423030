#include "worker/fill/space/unrolled.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

namespace tilemend {
namespace {

// A strip of squares bent about a tube of radius 5, each of two triangles.
struct Strip {
  std::vector<Point3> positions;
  std::vector<Triangle> triangles;
};

Strip Bent(int32_t squares) {
  Strip strip;
  for (int32_t i = 0; i <= squares; ++i) {
    for (const double x : {0.0, 1.0}) {
      strip.positions.emplace_back(x, 5 * std::sin(0.2 * i), 5 * std::cos(0.2 * i));
    }
  }
  for (int32_t i = 0; i < squares; ++i) {
    const int32_t a = 2 * i;
    strip.triangles.push_back({a, a + 1, a + 3});
    strip.triangles.push_back({a, a + 3, a + 2});
  }
  return strip;
}

TEST(UnrolledTest, KeepsTheShapeOfEachTriangle) {
  const Strip strip = Bent(25);
  const Unrolled disc(strip.positions, strip.triangles);
  for (const Triangle& t : strip.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      EXPECT_NEAR((disc.flat()[a] - disc.flat()[b]).norm(), (strip.positions[a] - strip.positions[b]).norm(), 1e-9);
    }
    const Point2 u = disc.flat()[t[1]] - disc.flat()[t[0]], v = disc.flat()[t[2]] - disc.flat()[t[0]];
    EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0) << "counter-clockwise";
  }
}

TEST(UnrolledTest, LiftsBackToTheDisc) {
  const Strip strip = Bent(25);
  const Unrolled disc(strip.positions, strip.triangles);
  for (size_t v = 0; v < strip.positions.size(); ++v) {
    EXPECT_LT((disc.Lift(disc.flat()[v]) - strip.positions[v]).norm(), 1e-9);
  }
  for (const Triangle& t : strip.triangles) {
    const Point2 middle = (disc.flat()[t[0]] + disc.flat()[t[1]] + disc.flat()[t[2]]) / 3;
    const Point3 wanted = (strip.positions[t[0]] + strip.positions[t[1]] + strip.positions[t[2]]) / 3;
    EXPECT_LT((disc.Lift(middle) - wanted).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace tilemend
