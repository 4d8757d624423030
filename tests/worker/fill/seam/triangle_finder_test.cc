#include "worker/fill/seam/triangle_finder.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// A square in two triangles, one upright triangle on its side.
const std::vector<Point3> kPoints = {{0, 0, 1}, {2, 0, 2}, {2, 2, 3}, {0, 2, 4}, {2, 1, 9}};
const std::vector<Triangle> kTriangles = {{1, 2, 4}, {0, 1, 2}, {0, 2, 3}};

TEST(TriangleFinderTest, TellsTheSharesOfTheCorners) {
  const TriangleFinder finder(kPoints, kTriangles);
  const auto place = finder.Find({1.5, 0.5});
  ASSERT_TRUE(place.has_value());
  EXPECT_EQ(place->triangle, kTriangles[1]);
  EXPECT_TRUE(place->share.isApprox(Eigen::Vector3d(0.25, 0.5, 0.25)));
}

TEST(TriangleFinderTest, FindsPlacesOnEdgesAndAtCorners) {
  const TriangleFinder finder(kPoints, kTriangles);
  for (const Point2& p : {Point2(1, 1), Point2(0, 1), Point2(2, 0.3), Point2(0, 0), Point2(2, 2)}) {
    const auto place = finder.Find(p);
    ASSERT_TRUE(place.has_value()) << p.transpose();
    EXPECT_NE(place->triangle, kTriangles[0]) << "which has no area seen from above";
    Point2 sum(0, 0);
    for (int k = 0; k < 3; ++k) sum += place->share[k] * kPoints[place->triangle[k]].head<2>();
    EXPECT_TRUE(sum.isApprox(p)) << p.transpose();
  }
}

TEST(TriangleFinderTest, FindsNoneOutside) {
  const TriangleFinder finder(kPoints, kTriangles);
  EXPECT_FALSE(finder.Find({-0.01, 1}).has_value());
  EXPECT_FALSE(finder.Find({3, 3}).has_value());
  EXPECT_FALSE(TriangleFinder({}, {}).Find({0, 0}).has_value());
}

}  // namespace
}  // namespace tilemend
