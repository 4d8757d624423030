#include "worker/fill/surface/fair_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

// A patch in the middle of a mesh of nearly equilateral triangles (so that all weights of eq. 3 are positive): vertices
// nearer to the middle than `radius` are new, the band is all
// else that touches the rim. Heights of fixed vertices by `height`, of new ones 0. `jitter` moves vertices sideways.
FairingProblem DiscProblem(double radius, double jitter, const HeightFunction& height) {
  const TriMesh mesh = Moved(SquaresMesh(-12, 12, -12, 12, [](int32_t, int32_t) { return true; }),
                             [](const Point3& p) { return Point3(p.x() - p.y() / 2, p.y() * std::sqrt(0.75), 0); });
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  const auto is_new = [&](int32_t v) { return mesh.points[v].head<2>().norm() < radius; };
  std::vector<bool> inner, rim(mesh.points.size(), false);
  for (size_t v = 0; v < mesh.points.size(); ++v) inner.push_back(is_new(static_cast<int32_t>(v)));
  for (const Triangle& t : mesh.triangles) {
    if (!inner[t[0]] && !inner[t[1]] && !inner[t[2]]) continue;
    for (const int32_t v : t) rim[v] = !inner[v];
  }
  FairingProblem problem;
  std::vector<int32_t> number(mesh.points.size());
  const auto add = [&](const std::vector<bool>& of) {
    for (size_t v = 0; v < of.size(); ++v) {
      if (!of[v]) continue;
      number[v] = static_cast<int32_t>(problem.points.size());
      const double x = mesh.points[v].x() + shift(random), y = mesh.points[v].y() + shift(random);
      problem.points.emplace_back(x, y, inner[v] ? 0 : height(x, y));
    }
  };
  std::vector<bool> others;
  for (size_t v = 0; v < inner.size(); ++v) others.push_back(!inner[v] && !rim[v]);
  add(rim);
  problem.rim_count = static_cast<int32_t>(problem.points.size());
  add(inner);
  problem.new_count = static_cast<int32_t>(problem.points.size()) - problem.rim_count;
  add(others);
  for (const Triangle& t : mesh.triangles) {
    const Triangle out = {number[t[0]], number[t[1]], number[t[2]]};
    if (inner[t[0]] || inner[t[1]] || inner[t[2]]) {
      problem.patch.push_back(out);
    } else if (rim[t[0]] || rim[t[1]] || rim[t[2]]) {
      problem.band.push_back(out);
    }
  }
  problem.has_equation.assign(static_cast<size_t>(problem.rim_count), true);
  return problem;
}

double WorstError(const FairingProblem& problem, const HeightFunction& height) {
  double worst = 0;
  for (int32_t v = problem.rim_count; v < problem.rim_count + problem.new_count; ++v) {
    const Point3& p = problem.points[v];
    worst = std::max(worst, std::abs(p.z() - height(p.x(), p.y())));
  }
  return worst;
}

double Plane(double x, double y) { return 3 + 0.5 * x - 0.25 * y; }
double Bowl(double x, double y) { return x * x + y * y; }

TEST(FairHeightsTest, ReproducesAPlane) {
  FairingProblem problem = DiscProblem(6, 0.1, Plane);
  ASSERT_GT(problem.new_count, 100);
  ASSERT_TRUE(FairHeights(problem));
  EXPECT_LT(WorstError(problem, Plane), 1e-9);
}

TEST(FairHeightsTest, ReproducesAPlaneWithoutABand) {
  FairingProblem problem = DiscProblem(6, 0.1, Plane);
  problem.band.clear();
  problem.has_equation.assign(problem.has_equation.size(), false);
  ASSERT_TRUE(FairHeights(problem));
  EXPECT_LT(WorstError(problem, Plane), 1e-9);
}

TEST(FairHeightsTest, GoesOnWithTheCurvatureOfTheBand) {
  FairingProblem problem = DiscProblem(6, 0, Bowl);
  ASSERT_TRUE(FairHeights(problem));
  EXPECT_LT(WorstError(problem, Bowl), 0.001 * 36);
}

TEST(FairHeightsTest, GoesOnWithTheCurvatureOfAnIrregularBand) {
  FairingProblem problem = DiscProblem(6, 0.1, Bowl);
  ASSERT_TRUE(FairHeights(problem));
  EXPECT_LT(WorstError(problem, Bowl), 0.02 * 36);
}

// Without a band the slope at the rim is not known and the patch is nearly the flat membrane: the band is what counts.
TEST(FairHeightsTest, DoesNotCurveWithoutABand) {
  FairingProblem problem = DiscProblem(6, 0, Bowl);
  problem.band.clear();
  problem.has_equation.assign(problem.has_equation.size(), false);
  ASSERT_TRUE(FairHeights(problem));
  EXPECT_GT(WorstError(problem, Bowl), 0.5 * 36);
}

TEST(FairHeightsTest, DoesNotDependOnTheHeightsBefore) {
  FairingProblem a = DiscProblem(4, 0.1, Bowl), b = a;
  for (int32_t k = 0; k < b.new_count; ++k) b.points[b.rim_count + k].z() = 100 * k;
  ASSERT_TRUE(FairHeights(a));
  ASSERT_TRUE(FairHeights(b));
  for (size_t v = 0; v < a.points.size(); ++v) EXPECT_EQ(a.points[v], b.points[v]);
}

TEST(FairHeightsTest, KeepsFixedVerticesAndPlaces) {
  const FairingProblem before = DiscProblem(4, 0.1, Bowl);
  FairingProblem after = before;
  ASSERT_TRUE(FairHeights(after));
  for (int32_t v = 0; v < static_cast<int32_t>(before.points.size()); ++v) {
    const bool is_new = v >= before.rim_count && v < before.rim_count + before.new_count;
    EXPECT_EQ(after.points[v].head<2>(), before.points[v].head<2>());
    EXPECT_TRUE(is_new || after.points[v].z() == before.points[v].z()) << v;
  }
}

TEST(FairHeightsTest, AcceptsAPatchWithoutNewVertices) {
  FairingProblem problem;
  problem.points = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};
  problem.rim_count = 3;
  problem.patch = {{0, 1, 2}};
  problem.has_equation = {true, true, true};
  EXPECT_TRUE(FairHeights(problem));
}

TEST(AdjustHeightsTest, WeighsNeighboursByTheirInverseDistance) {
  FairingProblem problem;
  problem.points = {{-1, 0, 0}, {0, -4, 8}, {2, 0, 6}, {0, 4, 8}, {0, 0, -99}};
  problem.rim_count = 4;
  problem.new_count = 1;
  problem.patch = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  problem.has_equation.assign(4, true);
  AdjustHeights(problem);
  EXPECT_DOUBLE_EQ(problem.points[4].z(), (0.0 / 1 + 8.0 / 4 + 6.0 / 2 + 8.0 / 4) / (1.0 + 0.25 + 0.5 + 0.25));
}

// A strip: rim 0..5 around two new vertices, 6 at (0, 0) and 7 at (2, 0). Eq. 1 takes first and second neighbours, each
// once: for vertex 6 those are all six of the rim (4 and 5 with 7 between), as 7 has no height yet.
TEST(AdjustHeightsTest, TakesFirstAndSecondNeighboursOnceEach) {
  FairingProblem problem;
  problem.points = {{0, -2, 1}, {2, -2, 2}, {4, 0, 3}, {2, 2, 4}, {0, 2, 5}, {-2, 0, 6}, {0, 0, -99}, {2, 0, -99}};
  problem.rim_count = 6;
  problem.new_count = 2;
  problem.patch = {{0, 7, 6}, {0, 1, 7}, {1, 2, 7}, {2, 3, 7}, {3, 6, 7}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}};
  problem.has_equation.assign(6, true);
  AdjustHeights(problem);
  double sum = 0, weights = 0;
  for (int32_t v = 0; v < 6; ++v) {
    const double w = 1 / problem.points[v].head<2>().norm();
    sum += w * problem.points[v].z();
    weights += w;
  }
  EXPECT_DOUBLE_EQ(problem.points[6].z(), sum / weights);
}

TEST(AdjustHeightsTest, GivesEveryNewVertexAHeightBetweenThoseOfTheRim) {
  FairingProblem problem = DiscProblem(6, 0.1, Plane);
  for (int32_t k = 0; k < problem.new_count; ++k) problem.points[problem.rim_count + k].z() = -1000;
  AdjustHeights(problem);
  double lo = 1e9, hi = -1e9;
  for (int32_t v = 0; v < problem.rim_count; ++v) {
    lo = std::min(lo, problem.points[v].z());
    hi = std::max(hi, problem.points[v].z());
  }
  for (int32_t v = problem.rim_count; v < problem.rim_count + problem.new_count; ++v) {
    EXPECT_GE(problem.points[v].z(), lo);
    EXPECT_LE(problem.points[v].z(), hi);
  }
}

}  // namespace
}  // namespace tilemend
