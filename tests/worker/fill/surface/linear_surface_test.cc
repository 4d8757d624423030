#include "worker/fill/surface/linear_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

double Plane(const Point2& p) { return 3 + 0.25 * p.x() - 0.5 * p.y(); }

TEST(LinearHeightsTest, AreThoseOfThePlaneThroughTheGround) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-50, 50);
  std::vector<Point3> ground = {{-60, -60, 0}, {60, -60, 0}, {60, 60, 0}, {-60, 60, 0}};
  std::vector<Point2> at;
  for (int i = 0; i < 200; ++i) ground.emplace_back(place(random), place(random), 0);
  for (Point3& p : ground) p.z() = Plane(p.head<2>());
  for (int i = 0; i < 1000; ++i) at.emplace_back(place(random), place(random));
  const std::vector<double> heights = LinearHeights(ground, at);
  for (size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(heights[i], Plane(at[i]), 1e-5) << at[i].transpose();
}

TEST(LinearHeightsTest, BeyondTheGroundAreThoseOfItsOutline) {
  const std::vector<Point3> ground = {{0, 0, 1}, {10, 0, 2}, {0, 10, 1}};
  EXPECT_THAT(LinearHeights(ground, {{5, -3}, {15, -20}, {-1, 5}}),
              ElementsAre(DoubleNear(1.5, 1e-9), DoubleNear(2, 1e-9), DoubleNear(1, 1e-9)));
}

TEST(LinearHeightsTest, FewPointsWillDo) {
  EXPECT_THAT(LinearHeights({{4, 5, 6}}, {{4, 5}, {0, 0}}), ElementsAre(6, 6));
  EXPECT_THAT(LinearHeights({{0, 0, 0}, {4, 0, 4}}, {{1, 0}, {3, 2}}),
              ElementsAre(DoubleNear(1, 1e-6), DoubleNear(3, 1e-6)));
}

TEST(LinearHeightsTest, OfPointsOverOnePlaceOneCounts) {
  EXPECT_THAT(LinearHeights({{0, 0, 3}, {0, 0, 3}, {8, 0, 3}, {0, 8, 3}}, {{0, 0}, {2, 2}}), ElementsAre(3, 3));
}

// A strip of ground 20 m wide between two shores, in squares of 1 m.
ThinPlateProblem Strip(const std::function<double(const Point3&)>& height) {
  const TriMesh mesh = SquaresMesh(0, 20, 0, 40, [](int32_t, int32_t) { return true; });
  ThinPlateProblem problem;
  problem.points = mesh.points;
  problem.patch = mesh.triangles;
  for (Point3& p : problem.points) {
    const bool shore = p.x() == 0 || p.x() == 20;
    p.z() = shore ? height(p) : 0;
    problem.known.push_back(shore);
  }
  problem.has_equation.assign(problem.points.size(), false);
  return problem;
}

// What is known of it.
std::vector<Point3> ShoreOf(const ThinPlateProblem& strip) {
  std::vector<Point3> shore;
  for (size_t v = 0; v < strip.points.size(); ++v) {
    if (strip.known[v]) shore.push_back(strip.points[v]);
  }
  return shore;
}

TEST(SolveLinearTest, GoesStraightAcross) {
  ThinPlateProblem problem = Strip([](const Point3& p) { return p.y() < 20 ? 0.0 : 8.0; });
  ASSERT_TRUE(SolveLinear(ShoreOf(problem), {}, {}, problem));
  for (const Point3& p : problem.points) {
    const bool off_the_step = std::abs(p.y() - 20) > 10;
    EXPECT_NEAR(p.z(), p.y() < 20 ? 0 : 8, off_the_step ? 0.1 : 8) << p.transpose();
  }
}

double HeightAt(const ThinPlateProblem& problem, double x, double y) {
  return std::ranges::find_if(problem.points, [&](const Point3& p) { return p.x() == x && p.y() == y; })->z();
}

// How much two planes of this slope bend where they meet, over a metre on both sides.
double BendBetweenPlanes(double slope) {
  ThinPlateProblem problem = Strip([slope](const Point3& p) { return slope * std::abs(p.y() - 20); });
  EXPECT_TRUE(SolveLinear(ShoreOf(problem), {}, {}, problem));
  EXPECT_NEAR(HeightAt(problem, 10, 10), 10 * slope, 0.1);
  return HeightAt(problem, 10, 21) - 2 * HeightAt(problem, 10, 20) + HeightAt(problem, 10, 19);
}

TEST(SolveLinearTest, RoundsEdgesOff) {
  const double bend = BendBetweenPlanes(1);
  EXPECT_LT(bend, 1.2) << "2 where the two planes meet";
  EXPECT_GT(bend, 0.5) << "walls stay walls";
}

TEST(SolveLinearTest, WhatStandsOnTheShoreCountsNothing) {
  ThinPlateProblem problem = Strip([](const Point3& p) { return p.x() == 0 && p.y() == 20 ? 30.0 : 2.0; });
  std::vector<bool> on_object(problem.points.size(), false);
  for (size_t v = 0; v < on_object.size(); ++v) on_object[v] = problem.points[v].z() == 30;
  const std::vector<Point3> corners = {{0, 0, 2}, {20, 0, 2}, {20, 40, 2}, {0, 40, 2}};
  ASSERT_TRUE(SolveLinear(corners, on_object, {}, problem));
  for (const Point3& p : problem.points) EXPECT_NEAR(p.z(), 2, 1e-6);
  std::vector<std::optional<double>> ground(problem.points.size());
  const auto object = std::find(on_object.begin(), on_object.end(), true) - on_object.begin();
  ground[object] = 1.5;
  ASSERT_TRUE(SolveLinear(corners, on_object, ground, problem));
  EXPECT_EQ(problem.points[object].z(), 1.5);
}

// As in a cell all of whose rim stands on objects.
TEST(SolveLinearTest, TheGroundMayLieElsewhere) {
  ThinPlateProblem problem = Strip([](const Point3&) { return 9.0; });
  const std::vector<bool> on_object = problem.known;
  ASSERT_TRUE(SolveLinear({{-50, -50, 0}, {70, -50, 12}, {70, 90, 12}, {-50, 90, 0}}, on_object, {}, problem));
  for (const Point3& p : problem.points) EXPECT_NEAR(p.z(), 0.1 * (p.x() + 50), 0.3) << p.transpose();
}

}  // namespace
}  // namespace tilemend
