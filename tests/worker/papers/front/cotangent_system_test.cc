#include "worker/papers/front/cotangent_system.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

TEST(HalfCotangentsTest, AreThoseOfTheAngles) {
  const Eigen::Vector3d halves = HalfCotangents({Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0)});
  EXPECT_NEAR(halves[0], 0, 1e-12);
  EXPECT_NEAR(halves[1], 0.5, 1e-12);
  EXPECT_NEAR(halves[2], 0.5, 1e-12);
}

TEST(HalfCotangentsTest, StayFiniteWithoutArea) {
  const Eigen::Vector3d halves = HalfCotangents({Point3(0, 0, 0), Point3(1, 0, 0), Point3(2, 0, 0)});
  EXPECT_TRUE(halves.allFinite());
}

TEST(CotangentSystemTest, LinearFunctionsAreHarmonic) {
  const FrontRim rim = FlatRim(30, 0.1);
  const FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
  ASSERT_TRUE(patch.closed());
  const auto count = static_cast<int32_t>(rim.points.size());
  const CotangentSystem system(patch.points, patch.triangles, count);
  ASSERT_TRUE(system.ok());
  const auto f = [](const Point3& p) { return 2 * p.x() - 3 * p.y() + 1; };
  Eigen::MatrixXd of_rim(count, 1);
  for (int32_t v = 0; v < count; ++v) of_rim(v, 0) = f(rim.points[v]);
  const auto free = static_cast<Eigen::Index>(patch.points.size()) - count;
  const Eigen::MatrixXd inside = system.Solve(of_rim, Eigen::MatrixXd::Zero(free, 1));
  for (Eigen::Index v = 0; v < free; ++v) EXPECT_NEAR(inside(v, 0), f(patch.points[count + v]), 1e-9);
}

TEST(CotangentSystemTest, GivesTheFunctionWithThatLaplacian) {
  // One point inside a square: f rises by what its weight does not take.
  const std::vector<Point3> points = {Point3(1, 0, 0), Point3(0, 1, 0), Point3(-1, 0, 0), Point3(0, -1, 0),
                                      Point3(0, 0, 0)};
  const std::vector<Triangle> triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const CotangentSystem system(points, triangles, 4);
  const Eigen::MatrixXd f =
      system.Solve(Eigen::MatrixXd::Constant(4, 1, 7), Eigen::MatrixXd::Constant(1, 1, -2 * system.WeightOf(4)));
  EXPECT_NEAR(f(0, 0), 9, 1e-12);
}

}  // namespace
}  // namespace tilemend
