#include "worker/fill/surface/fair_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

// A disc in rings: the inner ones unknown and displaced, the outer two known, of which the last is the band.
FairSurfaceProblem DiscProblem(const std::function<Point3(const Point3&)>& shape, const Point3& off, int32_t rings = 5,
                               int32_t sectors = 12) {
  const TriMesh mesh = DiscMesh(rings, sectors);
  FairSurfaceProblem problem;
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const int ring = v == 0 ? 0 : static_cast<int>((v - 1) / sectors) + 1;
    problem.known.push_back(ring > rings - 2);
    problem.has_equation.push_back(ring < rings);
    problem.points.emplace_back(shape(mesh.points[v]) + (ring > rings - 2 ? Point3(0, 0, 0) : off));
  }
  for (const Triangle& t : mesh.triangles) {
    const int32_t most = std::max({t[0], t[1], t[2]});
    (most > (rings - 1) * sectors ? problem.band : problem.patch).push_back(t);
  }
  return problem;
}

TEST(FairSurfaceTest, StaysOnATiltedPlane) {
  const auto plane = [](const Point3& p) { return Point3(p.x(), p.y(), 0.5 * p.x() - 2 * p.y() + 3); };
  const std::vector<Point3> truth = DiscProblem(plane, {0, 0, 0}).points;
  FairSurfaceProblem problem = DiscProblem(plane, {0.1, -0.2, 0.7});
  ASSERT_TRUE(FairSurface(truth, problem));
  for (size_t v = 0; v < truth.size(); ++v) EXPECT_NEAR(problem.points[v].z(), plane(problem.points[v]).z(), 1e-9);
}

TEST(FairSurfaceTest, BulgesLikeTheSphereAroundIt) {
  const auto sphere = [](const Point3& p) {
    const double r = p.head<2>().norm(), angle = r / 8;
    const double s = r > 0 ? 8 * std::sin(angle) / r : 1;
    return Point3(s * p.x(), s * p.y(), 8 * std::cos(angle));
  };
  const std::vector<Point3> truth = DiscProblem(sphere, {0, 0, 0}).points;
  FairSurfaceProblem problem = DiscProblem(sphere, {0, 0, -1});
  ASSERT_TRUE(FairSurface(truth, problem));
  for (size_t v = 0; v < truth.size(); ++v) EXPECT_NEAR(problem.points[v].norm(), 8, 0.05);
}

// The largest distance of a point from a cylinder of radius 8 about the y axis, over a disc that turns by so much.
double OffACylinder(double turn, bool evens_curvature) {
  const int32_t rings = 12, sectors = 48;
  const auto cylinder = [&](const Point3& p) {
    const double angle = p.x() / rings * turn / 2;
    return Point3(8 * std::sin(angle), p.y() / rings * 8 * turn / 2, 8 * std::cos(angle));
  };
  const std::vector<Point3> truth = DiscProblem(cylinder, {0, 0, 0}, rings, sectors).points;
  FairSurfaceProblem problem = DiscProblem(cylinder, {0, 0, -1}, rings, sectors);
  problem.evens_curvature = evens_curvature;
  EXPECT_TRUE(FairSurface(truth, problem));
  double off = 0;
  for (const Point3& p : problem.points) off = std::max(off, std::abs(std::hypot(p.x(), p.z()) - 8));
  return off;
}

TEST(FairSurfaceTest, GoesOnRoundWithEvenCurvature) {
  for (const double turn : {1.5, 2.0, 3.0}) {
    EXPECT_LT(OffACylinder(turn, true), OffACylinder(turn, false) / 5) << turn;
    EXPECT_LT(OffACylinder(turn, true), 0.04) << turn;
  }
}

// A disc of `rings` rings that maps onto a surface, the outer three known: the rim, the band and what is beyond.
FairSurfaceProblem DiscWithBeyond(const std::function<Point3(const Point3&)>& shape, int32_t rings, int32_t sectors) {
  FairSurfaceProblem problem = DiscProblem(shape, {0, 0, 0}, rings, sectors);
  problem.beyond = std::exchange(problem.band, {});
  std::vector<Triangle> patch;
  for (const Triangle& t : problem.patch) {
    (std::ranges::max(t) > (rings - 2) * sectors ? problem.band : patch).push_back(t);
  }
  problem.patch = std::move(patch);
  for (size_t v = 0; v < problem.points.size(); ++v) {
    problem.known[v] = static_cast<int32_t>(v) > (rings - 3) * sectors;
    problem.has_equation[v] = static_cast<int32_t>(v) <= (rings - 2) * sectors;
  }
  problem.evens_curvature = true;
  return problem;
}

// The largest distance of a point from a torus, over a disc on its inner side that turns by about 100 degrees.
//   stretch  of the shapes that triangles should keep
double OffATorus(bool tells_beyond, double stretch = 1) {
  const auto torus = [](const Point3& p) {
    const double along = p.x() / 10 * 0.9 / 2, around = std::numbers::pi + p.y() / 10 * 0.9;
    const double out = 3 + std::cos(around);
    return Point3(out * std::cos(along), out * std::sin(along), std::sin(around));
  };
  FairSurfaceProblem problem = DiscWithBeyond(torus, 11, 48);
  if (!tells_beyond) problem.beyond.clear();
  std::vector<Point3> shape = problem.points;
  for (Point3& p : shape) p.y() *= stretch;
  EXPECT_TRUE(FairSurface(shape, problem));
  double off = 0;
  for (const Point3& p : problem.points) {
    off = std::max(off, std::abs(std::hypot(p.head<2>().norm() - 3, p.z()) - 1));
  }
  return off;
}

TEST(FairSurfaceTest, GoesOnAsASaddleWhereTheCurvatureChangesAcrossTheRim) {
  EXPECT_LT(OffATorus(true), OffATorus(false) / 5);
}

TEST(FairSurfaceTest, SolvesAgainWhereTheShapesWereATenthTooLarge) { EXPECT_LT(OffATorus(true, 1.1), 0.003); }

// Over the blunt edge of a lens the second solve shrinks further from the truth: 0.0245, and the first is 0.0185 off.
TEST(FairSurfaceTest, TakesTheSolveWhoseCurvatureGoesOnBestAtTheRim) {
  const auto lens = [](const Point3& p) {
    const double angle = p.x() / 12 * 0.8;
    return Point3(1.5 * std::cos(angle), p.y() / 12 * 1.5 * std::sin(0.8), 0.6 * std::sin(angle));
  };
  FairSurfaceProblem problem = DiscWithBeyond(lens, 12, 48);
  const std::vector<Point3> truth = problem.points;
  ASSERT_TRUE(FairSurface(truth, problem));
  double off = 0;
  for (const Point3& p : problem.points) off += std::abs(std::hypot(p.x() / 1.5, p.z() / 0.6) - 1);
  EXPECT_LT(off / static_cast<double>(problem.points.size()), 0.02);
}

TEST(FairSurfaceTest, LeavesKnownPointsAlone) {
  const auto flat = [](const Point3& p) { return p; };
  FairSurfaceProblem problem = DiscProblem(flat, {0, 0, 1});
  problem.known.assign(problem.points.size(), true);
  const std::vector<Point3> before = problem.points;
  ASSERT_TRUE(FairSurface(before, problem));
  EXPECT_EQ(problem.points, before);
}

}  // namespace
}  // namespace tilemend
