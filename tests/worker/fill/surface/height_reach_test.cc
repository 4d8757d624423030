#include "worker/fill/surface/height_reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere, testing::MakePlate, testing::Nowhere, testing::Plate;

TEST(HeightReachTest, IsHalfTheRangeAndAQuarterOfTheSlope) {
  const Plate plate = MakePlate([](double x, double) { return 5 + 0.5 * x; }, Everywhere, Nowhere);
  const HeightReach reach = ReachOfRim(plate.problem);
  const double extent = 16 * std::sqrt(2.0), beyond = 4 + 0.5 * extent / 4;
  EXPECT_NEAR(reach.extent, extent, 1e-12);
  EXPECT_NEAR(reach.lo, 1 - beyond, 1e-9);
  EXPECT_NEAR(reach.hi, 9 + beyond, 1e-9);
  EXPECT_TRUE(reach.Holds(9));
  EXPECT_FALSE(reach.Holds(9 + beyond + 1));
  EXPECT_FALSE(reach.Holds(std::nan("")));
}

TEST(HeightReachTest, LooksAtUnknownHeightsAlone) {
  Plate plate = MakePlate([](double x, double) { return 0.5 * x; }, Everywhere, Nowhere);
  const HeightReach reach = ReachOfRim(plate.problem);
  EXPECT_TRUE(reach.HoldsUnknown(plate.problem));
  plate.problem.points[plate.at[{8, 8}]].z() = 1000;
  EXPECT_TRUE(reach.HoldsUnknown(plate.problem));
  plate.problem.points[plate.at[{0, 0}]].z() = 1000;
  EXPECT_FALSE(reach.HoldsUnknown(plate.problem));
}

TEST(HeightReachTest, WallsAreNoGround) {
  const auto steep = [](double slope) {
    const Plate plate = MakePlate([=](double x, double) { return slope * x; }, Everywhere, Nowhere);
    return IsGround(plate.problem, plate.problem.band[0]);
  };
  EXPECT_TRUE(steep(4.9));
  EXPECT_FALSE(steep(5.1));
}

}  // namespace
}  // namespace tilemend
