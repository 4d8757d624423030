#include "worker/papers/front/front_rules.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

namespace tilemend {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

FrontCorner Corner(const Point3& before, const Point3& after, std::span<const Point3> neighbours) {
  FrontCorner corner;
  corner.at = Point3(0, 0, 0);
  corner.before = before;
  corner.after = after;
  corner.normal = corner.carried = Vector3d::UnitZ();
  corner.neighbours = neighbours;
  corner.angle_rad = FrontAngle(corner.at, before, after, corner.normal);
  return corner;
}

TEST(FrontAngleTest, IsThatOnTheLeft) {
  const Point3 at(0, 0, 0), x(2, 0, 0), y(0, 1, 0);
  EXPECT_NEAR(FrontAngle(at, y, x, Vector3d::UnitZ()), kPi / 2, 1e-12);
  EXPECT_NEAR(FrontAngle(at, x, y, Vector3d::UnitZ()), 3 * kPi / 2, 1e-12);
  EXPECT_NEAR(FrontAngle(at, y, x, -Vector3d::UnitZ()), 3 * kPi / 2, 1e-12);
}

TEST(PlainRuleTest, DividesTheAngleAcrossTheCarriedNormal) {
  const FrontCorner corner = Corner(Point3(0, 1, 0), Point3(3, 0, 0), {});
  const Point3 p = PlainRule()(corner, 1.0 / 3);
  EXPECT_NEAR(p.norm(), corner.Length(), 1e-12);
  EXPECT_NEAR(std::atan2(p.y(), p.x()), kPi / 6, 1e-12);
  EXPECT_NEAR(p.z(), 0, 1e-12);
}

TEST(PlainRuleTest, DoesNotFollowEdgesOutOfThePlane) {
  const Point3 p = PlainRule()(Corner(Point3(-1, 0, -0.1), Point3(1, 0, -0.1), {}), 0.5);
  EXPECT_NEAR(p.z(), 0, 1e-12);
  EXPECT_GT(p.y(), 0.9);
}

TEST(PlainRuleTest, PrintedFollowsEdgesOutOfThePlane) {
  const Point3 p = PlainRule(FrontSteps::kPrinted)(Corner(Point3(-1, 0.5, -0.1), Point3(1, 0.5, -0.1), {}), 0.5);
  EXPECT_NEAR(p.z(), -0.2 * p.y(), 1e-12) << "on the plane of the two edges";
  EXPECT_GT(p.y(), 0.9);
}

TEST(PlainRuleTest, PrintedDividesAnAngleAboveAHalfTurnOnItsOwnSide) {
  const FrontCorner corner = Corner(Point3(-1, -1, 0.1), Point3(1, -1, 0.1), {});
  EXPECT_GT(corner.angle_rad, kPi);
  const Point3 p = PlainRule(FrontSteps::kPrinted)(corner, 0.5);
  EXPECT_GT(p.y(), 0.9);
  EXPECT_NEAR(p.z(), -0.1 * p.y(), 1e-12);
}

TEST(PlainRuleTest, PrintedTakesEdgesInLineAcrossTheNormal) {
  const Point3 p = PlainRule(FrontSteps::kPrinted)(Corner(Point3(-1, 0, 0), Point3(1, 0, 0), {}), 0.5);
  EXPECT_NEAR((p - Point3(0, 1, 0)).norm(), 0, 1e-12);
}

TEST(FrontCornerTest, NewEdgesAreNoShorterThanTheSize) {
  FrontCorner corner = Corner(Point3(0, 1, 0), Point3(3, 0, 0), {});
  EXPECT_DOUBLE_EQ(corner.Length(), 2);
  corner.size = 5;
  EXPECT_DOUBLE_EQ(corner.Length(), 5);
}

TEST(NormalCurvatureRuleTest, StaysOnASphere) {
  const double radius = 5;
  std::vector<Point3> neighbours;
  for (const double angle : {0.0, -0.8, -1.6, -2.4, -kPi}) {
    neighbours.emplace_back(std::cos(angle), std::sin(angle), std::sqrt(radius * radius - 1) - radius);
  }
  const FrontCorner corner = Corner(neighbours.back(), neighbours.front(), neighbours);
  const Point3 p = NormalCurvatureRule({})(corner, 0.5);
  EXPECT_NEAR((p - Point3(0, 0, -radius)).norm(), radius, 2e-3);
  EXPECT_GT(p.y(), 0.9);
}

TEST(NormalCurvatureRuleTest, FollowsASaddleInEachDirection) {
  std::vector<Point3> neighbours;
  for (int i = 0; i < 12; ++i) {
    const double x = std::cos(i * kPi / 6), y = std::sin(i * kPi / 6);
    neighbours.emplace_back(x, y, 0.1 * (x * x - y * y));
  }
  const FrontCorner to_y = Corner(Point3(-1, 0, 0), Point3(1, 0, 0), neighbours);
  EXPECT_LT(NormalCurvatureRule({})(to_y, 0.5).z(), -0.08);
  const FrontCorner to_x = Corner(Point3(0, 1, 0), Point3(0, -1, 0), neighbours);
  EXPECT_GT(NormalCurvatureRule({})(to_x, 0.5).z(), 0.08);
}

// Equation 4 of the vertex on the plane of the edges, which goes down with them: 2 n.v / length.
TEST(NormalCurvatureRuleTest, PrintedTakesTheCurvatureOfTheNewVertexItself) {
  const FrontCorner corner = Corner(Point3(-1, 0.5, -0.1), Point3(1, 0.5, -0.1), {});
  const Point3 plain = PlainRule(FrontSteps::kPrinted)(corner, 0.5);
  EXPECT_LT((NormalCurvatureRule(0, FrontSteps::kPrinted)(corner, 0.5) - plain).norm(), 1e-12);
  const Vector3d v = plain.normalized();
  const Vector3d bent = v + 0.3 * (2 * v.z() / corner.Length()) * Vector3d::UnitZ();
  const Point3 p = NormalCurvatureRule(0.3, FrontSteps::kPrinted)(corner, 0.5);
  EXPECT_LT((p - corner.Length() * bent.normalized()).norm(), 1e-12);
}

TEST(NormalCurvatureRuleTest, DoesNotBendWithoutBend) {
  const std::vector<Point3> neighbours = {Point3(1, 0, -0.3), Point3(-1, 0, -0.3), Point3(0, -1, -0.3)};
  const FrontCorner corner = Corner(neighbours[1], neighbours[0], neighbours);
  EXPECT_NEAR(NormalCurvatureRule(0)(corner, 0.5).z(), 0, 1e-12);
  EXPECT_LT(NormalCurvatureRule(1)(corner, 0.5).z(), -0.1);
}

}  // namespace
}  // namespace tilemend
