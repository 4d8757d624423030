#include "worker/fill/thin_plate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

constexpr int32_t kHalf = 8;  // the patch is the square of this half side in the middle of a larger mesh

struct Plate {
  ThinPlateProblem problem;
  std::map<std::pair<double, double>, size_t> at;
};

// A mesh of squares with two rings of known points around the unknown ones. Points for which `keep` is false are left
// out with their triangles; `known` says which of the others have a height besides the rings.
Plate MakePlate(const HeightFunction& height, const std::function<bool(double, double)>& keep,
                const std::function<bool(double, double)>& known) {
  const TriMesh mesh = SquaresMesh(-kHalf - 3, kHalf + 3, -kHalf - 3, kHalf + 3, [](int32_t, int32_t) { return true; });
  Plate plate;
  std::vector<int32_t> number(mesh.points.size(), -1);
  const auto outer = [](const Point3& p) { return p.head<2>().cwiseAbs().maxCoeff() >= kHalf; };
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    if (!keep(p.x(), p.y())) continue;
    number[v] = static_cast<int32_t>(plate.problem.points.size());
    plate.at[{p.x(), p.y()}] = plate.problem.points.size();
    const bool fixed = outer(p) || known(p.x(), p.y());
    plate.problem.points.emplace_back(p.x(), p.y(), fixed ? height(p.x(), p.y()) : 0);
    plate.problem.known.push_back(fixed);
    plate.problem.full_ring.push_back(p.head<2>().cwiseAbs().maxCoeff() <= kHalf && !known(p.x(), p.y()));
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle out = {number[t[0]], number[t[1]], number[t[2]]};
    if (out[0] < 0 || out[1] < 0 || out[2] < 0) continue;
    const bool band = outer(mesh.points[t[0]]) && outer(mesh.points[t[1]]) && outer(mesh.points[t[2]]);
    (band ? plate.problem.band : plate.problem.patch).push_back(out);
  }
  return plate;
}

bool Everywhere(double, double) { return true; }
bool Nowhere(double, double) { return false; }

double LargestError(const Plate& plate, const HeightFunction& height) {
  double largest = 0;
  for (const Point3& p : plate.problem.points) largest = std::max(largest, std::abs(p.z() - height(p.x(), p.y())));
  return largest;
}

TEST(SolveThinPlateTest, ReproducesAPlane) {
  const auto plane = [](double x, double y) { return 3 + 0.5 * x - 0.25 * y; };
  Plate plate = MakePlate(plane, Everywhere, Nowhere);
  ASSERT_TRUE(SolveThinPlate(plate.problem).has_value());
  EXPECT_LT(LargestError(plate, plane), 1e-9);
}

TEST(SolveThinPlateTest, ReproducesAPlaneUnderTension) {
  const auto plane = [](double x, double y) { return 3 + 0.5 * x - 0.25 * y; };
  Plate plate = MakePlate(plane, Everywhere, Nowhere);
  plate.problem.tension = 2;
  ASSERT_TRUE(SolveThinPlate(plate.problem).has_value());
  EXPECT_LT(LargestError(plate, plane), 1e-9);
}

TEST(SolveThinPlateTest, ReproducesAParaboloid) {
  const auto bowl = [](double x, double y) { return 0.1 * (x * x + y * y); };
  Plate plate = MakePlate(bowl, Everywhere, Nowhere);
  const auto laplacian = SolveThinPlate(plate.problem);
  ASSERT_TRUE(laplacian.has_value());
  EXPECT_LT(LargestError(plate, bowl), 1e-6);
  EXPECT_NEAR((*laplacian)[plate.at.at({0, 0})], 0.4, 1e-6);
}

TEST(SolveThinPlateTest, TensionPullsASaddleBumpFlat) {
  // A wave along the rim: the stiffer the pull, the smaller the heights inside.
  const auto wave = [](double x, double y) { return std::cos(0.3 * x) + std::sin(0.2 * y); };
  Plate slack = MakePlate(wave, Everywhere, Nowhere), taut = slack;
  taut.problem.tension = 100;
  ASSERT_TRUE(SolveThinPlate(slack.problem).has_value());
  ASSERT_TRUE(SolveThinPlate(taut.problem).has_value());
  Plate membrane = MakePlate(wave, Everywhere, Nowhere);
  ASSERT_TRUE(SolveMembrane(membrane.problem));
  const size_t middle = slack.at.at({0, 0});
  EXPECT_NEAR(taut.problem.points[middle].z(), membrane.problem.points[middle].z(), 0.05);
  EXPECT_GT(std::abs(slack.problem.points[middle].z() - membrane.problem.points[middle].z()), 0.1);
}

// The promise that makes cells independent: one half, given heights and Laplacians along the cut, has the solution of
// the whole.
TEST(SolveThinPlateTest, AHalfWithHeightsAndLaplaciansOnTheCutIsTheWhole) {
  const auto hills = [](double x, double y) { return std::sin(0.4 * x + 0.2) * std::cos(0.3 * y) + 0.02 * x * y; };
  Plate whole = MakePlate(hills, Everywhere, Nowhere);
  const auto laplacian = SolveThinPlate(whole.problem);
  ASSERT_TRUE(laplacian.has_value());
  const auto on_cut = [](double x, double y) { return x == 0 && std::abs(y) <= kHalf; };
  Plate half = MakePlate(
      hills, [](double x, double) { return x >= 0; }, on_cut);
  half.problem.laplacian.resize(half.problem.points.size());
  for (const auto& [place, v] : half.at) {
    if (!on_cut(place.first, place.second)) continue;
    half.problem.points[v].z() = whole.problem.points[whole.at.at(place)].z();
    half.problem.laplacian[v] = (*laplacian)[whole.at.at(place)];
  }
  ASSERT_TRUE(SolveThinPlate(half.problem).has_value());
  for (const auto& [place, v] : half.at) {
    EXPECT_NEAR(half.problem.points[v].z(), whole.problem.points[whole.at.at(place)].z(), 1e-8)
        << place.first << " " << place.second;
  }
}

TEST(SolveThinPlateTest, NothingToSolveIsNoError) {
  Plate plate = MakePlate([](double, double) { return 1.0; }, Everywhere, Everywhere);
  EXPECT_TRUE(SolveThinPlate(plate.problem).has_value());
}

}  // namespace
}  // namespace tilemend
