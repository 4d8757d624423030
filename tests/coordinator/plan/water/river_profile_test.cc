#include "coordinator/plan/water/river_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

// A number in [-1, 1), the same on every machine.
double Random(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-31 - 1; }

const std::vector<Point2> kLine = {{0, 0}, {200, 0}, {400, 0}};
constexpr double kNoise = 0.05;

// Both shores of a river along kLine, 15 m off it, that falls 1 mm a metre from 10 m. `bank(x, y)` lies on top.
template <typename Bank>
std::vector<RimChain> Shores(const Bank& bank) {
  std::mt19937 random(3);
  std::vector<RimChain> shores;
  for (const double y : {-15.0, 15.0}) {
    RimChain& shore = shores.emplace_back();
    for (int x = 0; x <= 400; ++x) {
      const double z = 10 - 0.001 * x + bank(x, y) + kNoise * std::sqrt(3) * Random(random);
      shore.push_back({Point3(x, y, z), 1});
    }
  }
  return shores;
}

double NoBank(double, double) { return 0; }

double WorstLevel(const RiverProfile& profile) {
  double worst = 0;
  for (const Point3& s : profile.water.stations) worst = std::max(worst, std::abs(s.z() - (10 - 0.001 * s.x())));
  return worst;
}

bool NeverRises(const RiverProfile& profile) {
  return std::is_sorted(profile.water.stations.begin(), profile.water.stations.end(),
                        [](const Point3& a, const Point3& b) { return a.z() > b.z(); });
}

TEST(FitRiverTest, FallsAsTheShoresDo) {
  const RiverProfile profile = FitRiver(kLine, Shores(NoBank));
  ASSERT_EQ(profile.water.stations.size(), 17u);
  EXPECT_LT(WorstLevel(profile), 0.07);
  EXPECT_TRUE(NeverRises(profile));
  EXPECT_NEAR(profile.water.stations.front().z() - profile.water.stations.back().z(), 0.4, 0.1);
}

TEST(FitRiverTest, TheLineMayRunUpstream) {
  const std::vector<Point2> upstream(kLine.rbegin(), kLine.rend());
  const RiverProfile profile = FitRiver(upstream, Shores(NoBank));
  EXPECT_LT(profile.water.stations.front().x(), 1);
  EXPECT_LT(WorstLevel(profile), 0.07);
}

// A bank across its lower end, as at the edge of a hole, and a line that goes on far beyond the shores.
TEST(FitRiverTest, ItGoesOnFallingToTheEndOfItsShores) {
  const auto bank = [](double x, double) { return x > 360 ? 3.0 : 0.0; };
  for (const bool upstream : {false, true}) {
    std::vector<Point2> line = {{-5000, 0}, {0, 0}, {400, 0}, {5400, 0}};
    if (upstream) std::ranges::reverse(line);
    const RiverProfile profile = FitRiver(line, Shores(bank));
    for (const Point3& s : profile.water.stations) {
      EXPECT_NEAR(s.z(), 10 - 0.001 * std::clamp(s.x(), 0.0, 400.0), 0.09) << s.x();
    }
    EXPECT_TRUE(NeverRises(profile));
  }
}

TEST(FitRiverTest, AQuayAlongOneShoreDoesNotLiftIt) {
  const auto quay = [](double x, double y) { return y > 0 && x > 100 && x < 250 ? 2.5 : 0; };
  EXPECT_LT(WorstLevel(FitRiver(kLine, Shores(quay))), 0.07);
}

TEST(FitRiverTest, WhatBothShoresRiseByIsRemovedAndTold) {
  const auto weir = [](double x, double) { return x > 200 && x < 275 ? 1.0 : 0; };
  const RiverProfile profile = FitRiver(kLine, Shores(weir));
  EXPECT_TRUE(NeverRises(profile));
  EXPECT_LT(WorstLevel(profile), 0.6);
  EXPECT_TRUE(std::any_of(profile.removed.begin(), profile.removed.end(),
                          [](const RemovedRise& r) { return r.rise > 0.8 && std::abs(r.at.x() - 200) < 30; }));
}

TEST(FitRiverTest, AStretchBetweenQuaysDoesNotLiftIt) {
  const RiverProfile profile = FitRiver(kLine, Shores([](double x, double) { return x > 40 && x < 110 ? 2.5 : 0.0; }));
  EXPECT_LT(WorstLevel(profile), 0.1);
  EXPECT_TRUE(NeverRises(profile));
  EXPECT_FALSE(profile.removed.empty());
}

TEST(FitRiverTest, QuaysAtItsLowerEndDoNotTurnIt) {
  const RiverProfile profile = FitRiver(kLine, Shores([](double x, double) { return x > 375 ? 12.0 : 0.0; }));
  EXPECT_LT(profile.water.stations.front().x(), 1);
  EXPECT_LT(WorstLevel(profile), 0.1);
}

TEST(FitRiverTest, TooFewHeightsAreNoRiver) {
  EXPECT_TRUE(FitRiver(kLine, std::vector<RimChain>{{{Point3(0, 15, 10), 1}}}).water.stations.empty());
}

// All edges lie upstream of their station, in a river that falls 1.6 %.
TEST(FitFallTest, EdgesAreMovedToTheirStations) {
  std::vector<RimChain> rim(1);
  for (const RimChain& chain : Shores(NoBank)) {
    for (ChainEdge e : chain) {
      const double beyond = std::fmod(e.middle.x() + 12.5, 25);
      if (beyond < 1 || beyond > 12) continue;
      e.middle.z() -= 0.015 * e.middle.x();
      rim[0].push_back(e);
    }
  }
  EXPECT_NEAR(FitFall(kLine, rim).slope, -0.016 * 25, 0.01);
}

TEST(FitFallTest, NoneWithoutLevels) {
  EXPECT_TRUE(FitFall(kLine, std::vector<RimChain>{{{Point3(0, 15, 10), 1}}}).stations.empty());
}

TEST(NotRisingTest, FallingValuesStay) {
  const std::vector<double> values = {5, 4, 4, 1};
  EXPECT_EQ(NotRising(values, std::vector<double>(4, 1.0)), values);
}

TEST(NotRisingTest, RisesArePooledAtTheirMean) {
  EXPECT_EQ(NotRising(std::vector<double>{5, 2, 3, 1}, std::vector<double>(4, 1.0)),
            (std::vector<double>{5, 2.5, 2.5, 1}));
  EXPECT_EQ(NotRising(std::vector<double>{1, 2}, std::vector<double>{3, 1}), (std::vector<double>{1.25, 1.25}));
}

}  // namespace
}  // namespace tilemend
