#include "common/codec/tiles3d/bounding_volume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using Kind = BoundingVolume::Kind;

// Earth-centred, by the definition of the ellipsoid.
Point3 EarthCentred(double longitude, double latitude, double height) {
  constexpr double kA = 6378137, kE2 = 0.006694379990141317;
  const double n = kA / std::sqrt(1 - kE2 * std::sin(latitude) * std::sin(latitude));
  return {(n + height) * std::cos(latitude) * std::cos(longitude),
          (n + height) * std::cos(latitude) * std::sin(longitude), (n * (1 - kE2) + height) * std::sin(latitude)};
}

TEST(BoundingVolumeTest, StaysIfItHoldsThePoints) {
  const BoundingVolume box{Kind::kBox, {1, 2, 3, 4, 0, 0, 0, 5, 0, 0, 0, 6}};
  EXPECT_EQ(GrownVolume(box, {{5, 7, 9}, {-3, -3, -3}, {1, 2, 3}}), box);
  EXPECT_EQ(GrownVolume(box, {}), box);
  const BoundingVolume sphere{Kind::kSphere, {1, 2, 3, 4}};
  EXPECT_EQ(GrownVolume(sphere, {{5, 2, 3}}), sphere);
}

TEST(BoundingVolumeTest, ABoxGrowsOnOneSide) {
  const BoundingVolume box{Kind::kBox, {0, 0, 0, 4, 0, 0, 0, 5, 0, 0, 0, 6}};
  EXPECT_THAT(GrownVolume(box, {{0, 0, -10}}).numbers, ElementsAre(0, 0, -2, 4, 0, 0, 0, 5, 0, 0, 0, 8));
}

TEST(BoundingVolumeTest, ATurnedBoxKeepsItsDirections) {
  const BoundingVolume box{Kind::kBox, {0, 0, 0, 1, 1, 0, -1, 1, 0, 0, 0, 1}};
  const BoundingVolume grown = GrownVolume(box, {{3, 3, 0}});
  EXPECT_THAT(grown.numbers, ElementsAre(1, 1, 0, 2, 2, 0, -1, 1, 0, 0, 0, 1));
  EXPECT_EQ(GrownVolume(grown, {{3, 3, 0}, {-1, -1, 1}}), grown);
}

TEST(BoundingVolumeTest, AFlatBoxGetsHeight) {
  const BoundingVolume box{Kind::kBox, {0, 0, 0, 4, 0, 0, 0, 5, 0, 0, 0, 0}};
  EXPECT_EQ(GrownVolume(box, {{1, 1, 0}}), box);
  const std::vector<double> grown = GrownVolume(box, {{0, 0, 3}}).numbers;
  EXPECT_EQ(grown[2], 1.5);
  EXPECT_EQ(std::abs(grown[11]), 1.5);
  const BoundingVolume point{Kind::kBox, std::vector<double>(12)};
  EXPECT_THAT(GrownVolume(point, {{2, 0, 0}}).numbers, ElementsAre(1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0));
}

TEST(BoundingVolumeTest, ASphereKeepsItsCentre) {
  EXPECT_THAT(GrownVolume({Kind::kSphere, {0, 0, 0, 1}}, {{3, 4, 0}}).numbers, ElementsAre(0, 0, 0, 5));
}

TEST(BoundingVolumeTest, InvertsTheEllipsoid) {
  for (const double latitude : {-1.5, -0.7, 0.0, 0.3, 1.2}) {
    for (const double height : {-400.0, 0.0, 8000.0}) {
      const Point3 at = GeodeticOf(EarthCentred(2, latitude, height));
      EXPECT_NEAR(at[0], 2, 1e-14);
      EXPECT_NEAR(at[1], latitude, 1e-13);
      EXPECT_NEAR(at[2], height, 1e-8);
    }
  }
}

TEST(BoundingVolumeTest, ARegionGrowsInEachDirection) {
  const BoundingVolume region{Kind::kRegion, {0.1, 0.2, 0.3, 0.4, -5, 50}};
  EXPECT_EQ(GrownVolume(region, {EarthCentred(0.2, 0.3, 10)}), region);
  const std::vector<double> grown =
      GrownVolume(region, {EarthCentred(0.05, 0.5, 60), EarthCentred(0.35, 0.1, -9)}).numbers;
  EXPECT_THAT(grown, ElementsAre(DoubleNear(0.05, 1e-12), DoubleNear(0.1, 1e-12), DoubleNear(0.35, 1e-12),
                                 DoubleNear(0.5, 1e-12), DoubleNear(-9, 1e-7), DoubleNear(60, 1e-7)));
}

TEST(BoundingVolumeTest, ARegionMayCrossTheAntimeridian) {
  const BoundingVolume region{Kind::kRegion, {3.1, 0, -3.1, 0.1, -5, 50}};
  EXPECT_EQ(GrownVolume(region, {EarthCentred(std::numbers::pi, 0.05, 0)}), region);
  EXPECT_NEAR(GrownVolume(region, {EarthCentred(-3.0, 0.05, 0)}).numbers[2], -3.0, 1e-12);
  EXPECT_NEAR(GrownVolume(region, {EarthCentred(3.0, 0.05, 0)}).numbers[0], 3.0, 1e-12);
}

}  // namespace
}  // namespace tilemend
