#include "worker/fill/surface/rim_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/worker/fill/surface/plates.h"

namespace tilemend {
namespace {

using testing::Everywhere, testing::Hills, testing::kLarge, testing::MakePlate, testing::Nowhere, testing::Plate;

TEST(RimSamplesTest, AreTheRimAndWhatLiesBesideIt) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const RimSamples rim = SampleRim(plate.problem, 16, 100);
  EXPECT_EQ(rim.rim_points, 64);
  EXPECT_GT(rim.samples.size(), 64);
  EXPECT_FALSE(rim.in_a_plane);
  for (const Point3& p : rim.samples) {
    EXPECT_GE(p.head<2>().cwiseAbs().maxCoeff(), 8);
    EXPECT_EQ(p.z(), Hills(p.x(), p.y()));
  }
}

TEST(RimSamplesTest, AreThinnedOutWhereTheRimIsLong) {
  const Plate plate = MakePlate(Hills, Everywhere, Nowhere, kLarge);
  const RimSamples rim = SampleRim(plate.problem, 64, 100);
  EXPECT_EQ(rim.rim_points, 256);
  EXPECT_LE(rim.samples.size(), 200);
  EXPECT_GT(rim.spacing, 0.64);
}

TEST(RimSamplesTest, SayWhetherTheyLieInAPlane) {
  const Plate plate = MakePlate([](double x, double y) { return 7 + 0.4 * x - 3 * y; }, Everywhere, Nowhere);
  EXPECT_TRUE(SampleRim(plate.problem, 16, 100).in_a_plane);
}

TEST(RimSamplesTest, OfNoRimAreNone) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  plate.problem.has_equation.assign(plate.problem.points.size(), false);
  EXPECT_EQ(SampleRim(plate.problem, 16, 100).rim_points, 0);
  EXPECT_TRUE(SampleRim(plate.problem, 16, 100).samples.empty());
}

}  // namespace
}  // namespace tilemend
