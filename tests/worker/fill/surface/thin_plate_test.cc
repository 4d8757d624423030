#include "worker/fill/surface/thin_plate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::kHalf;
using testing::LargestError;
using testing::MakePlate;
using testing::Nowhere;
using testing::Plate;

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

// Flat ground with a wall along the east side of the hole.
double Wall(double x, double) { return x > kHalf ? 30 : 0; }

TEST(FreeSteepRimTest, AWallHasNoSlopeToGoOnWith) {
  Plate clamped = MakePlate(Wall, Everywhere, Nowhere), freed = clamped;
  ASSERT_TRUE(SolveThinPlate(clamped.problem).has_value());
  EXPECT_LT(clamped.problem.points[clamped.at.at({kHalf - 4, 0})].z(), -5);
  FreeSteepRim(freed.problem);
  EXPECT_FALSE(freed.problem.has_equation[freed.at.at({kHalf, 0})]);
  EXPECT_TRUE(freed.problem.has_equation[freed.at.at({-kHalf, 0})]);
  ASSERT_TRUE(SolveThinPlate(freed.problem).has_value());
  for (const auto& [place, v] : freed.at) {
    if (freed.problem.known[v]) continue;
    EXPECT_NEAR(freed.problem.points[v].z(), 0, 1e-6) << place.first << " " << place.second;
  }
}

TEST(FreeSteepRimTest, GroundKeepsItsSlopes) {
  Plate plate = MakePlate([](double x, double y) { return 4 * x - 2 * y; }, Everywhere, Nowhere);
  const std::vector<bool> before = plate.problem.has_equation;
  FreeSteepRim(plate.problem);
  EXPECT_EQ(plate.problem.has_equation, before);
}

TEST(SolveWithinReachTest, LeavesASurfaceWithinReachAlone) {
  const auto bowl = [](double x, double y) { return 0.1 * (x * x + y * y); };
  Plate plate = MakePlate(bowl, Everywhere, Nowhere);
  ASSERT_TRUE(SolveWithinReach(plate.problem).has_value());
  EXPECT_EQ(plate.problem.tension, 0);
  EXPECT_LT(LargestError(plate, bowl), 1e-6);
}

double Lowest(const Plate& plate) {
  double z = 0;
  for (const Point3& p : plate.problem.points) z = std::min(z, p.z());
  return z;
}

TEST(SolveWithinReachTest, TightensASpike) {
  // A slope of 9 on one side of flat ground.
  const auto ramp = [](double x, double) { return x > kHalf ? 9 * (x - kHalf) : 0; };
  Plate slack = MakePlate(ramp, Everywhere, Nowhere), held = slack;
  ASSERT_TRUE(SolveThinPlate(slack.problem).has_value());
  EXPECT_LT(Lowest(slack), -9);
  ASSERT_TRUE(SolveWithinReach(held.problem).has_value());
  EXPECT_GT(held.problem.tension, 0);
  EXPECT_GT(Lowest(held), -0.5);
}

TEST(SolveWithinReachTest, TakesNoReachFromWalls) {
  // Walls on three sides; on the fourth flat ground with a slope of 4 in its middle.
  const auto street = [](double x, double y) {
    if (x > kHalf) return std::abs(y) < kHalf / 3 ? 4 * (x - kHalf) : 0;
    return 50 * std::max(0.0, std::max(std::abs(x), std::abs(y)) - kHalf);
  };
  Plate slack = MakePlate(street, Everywhere, Nowhere);
  FreeSteepRim(slack.problem);
  Plate held = slack;
  ASSERT_TRUE(SolveThinPlate(slack.problem).has_value());
  EXPECT_LT(Lowest(slack), -1.7);
  ASSERT_TRUE(SolveWithinReach(held.problem).has_value());
  EXPECT_GT(Lowest(held), -0.5);
}

}  // namespace
}  // namespace tilemend
