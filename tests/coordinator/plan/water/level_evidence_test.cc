#include "coordinator/plan/water/level_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/rims.h"

namespace tilemend {
namespace {

LevelEvidence EvidenceOfBox(const HeightAt& height, double noise = 0.02) {
  const MadeRim rim = BoxRim({0, 0}, {80, 40}, height, noise);
  return EvidenceOf(rim.chains, rim.outline);
}

TEST(LevelEvidenceTest, ALevelRimIsLevel) {
  const LevelEvidence e = EvidenceOfBox([](double, double) { return 12; });
  EXPECT_TRUE(e.is_level());
  EXPECT_TRUE(e.is_within_noise());
  EXPECT_NEAR(e.level, 12, 0.02);
  EXPECT_NEAR(e.noise, 0.02, 0.01);
  EXPECT_LT(e.sigma(), 0.04);
  EXPECT_NEAR(e.length, 240, 1e-9);
  EXPECT_EQ(e.edges, 240);
}

// Trees and houses along more than half of the rim, from every side.
TEST(LevelEvidenceTest, WhatStandsAtTheWaterDoesNotCount) {
  const auto trees = [](double x, double y) {
    return 12 + (std::sin(x + 2 * y) > -0.2 ? 6 + 3 * std::sin(7 * x + y) : 0);
  };
  const LevelEvidence e = EvidenceOfBox(trees);
  EXPECT_TRUE(e.is_level());
  EXPECT_TRUE(e.agrees());
  EXPECT_NEAR(e.level, 12, 0.03);
}

TEST(LevelEvidenceTest, AQuayOnOneSideDoesNotCount) {
  const LevelEvidence e = EvidenceOfBox([](double, double y) { return y > 39 ? 14 : 12; });
  EXPECT_TRUE(e.is_level());
  EXPECT_NEAR(e.level, 12, 0.03);
}

TEST(LevelEvidenceTest, SlopesAndHillsAreNotLevel) {
  EXPECT_FALSE(EvidenceOfBox([](double x, double) { return 0.02 * x; }).is_level());
  EXPECT_FALSE(EvidenceOfBox([](double x, double y) { return 0.03 * x + 0.02 * y; }).is_level());
  EXPECT_FALSE(EvidenceOfBox([](double x, double y) { return 3 * std::sin(x / 15) + std::cos(y / 12); }).is_level());
}

TEST(LevelEvidenceTest, AFewPlacesTellTooLittle) {
  const MadeRim rim = BoxRim({0, 0}, {6, 4}, [](double, double) { return 3; });
  const LevelEvidence e = EvidenceOf(rim.chains, rim.outline);
  EXPECT_FALSE(e.is_enough());
  EXPECT_FALSE(e.is_level());
  EXPECT_NEAR(e.level, 3, 0.03);
}

// Rough heights half a metre below the level, along two fifths of the rim.
TEST(LevelEvidenceTest, SmoothEdgesWeighMoreThanRoughOnes) {
  const auto height = [](double x, double y) { return y < 30 ? 12 : 11.5 + 0.2 * std::sin(40 * x + 41 * y); };
  EXPECT_NEAR(EvidenceOfBox(height, 0).level, 12, 0.01);
}

TEST(LevelEvidenceTest, DoesNotDependOnWhereTheRimBegins) {
  const auto height = [](double x, double y) { return 12 + 0.3 * std::sin(x) + 0.2 * std::cos(3 * y); };
  MadeRim rim = BoxRim({0, 0}, {80, 40}, height);
  const LevelEvidence before = EvidenceOf(rim.chains, rim.outline);
  std::ranges::reverse(rim.chains[0]);
  std::ranges::reverse(rim.outline);
  const LevelEvidence after = EvidenceOf(rim.chains, rim.outline);
  EXPECT_EQ(after.level, before.level);
  EXPECT_EQ(after.disagreement, before.disagreement);
  EXPECT_EQ(after.dry_difference, before.dry_difference);
  EXPECT_EQ(after.noise, before.noise);
}

TEST(LevelEvidenceTest, MovesWithTheRim) {
  const auto height = [](double x, double y) { return 12 + 0.3 * std::sin(x) + 0.2 * std::cos(3 * y); };
  const LevelEvidence here = EvidenceOfBox(height);
  const LevelEvidence up = EvidenceOfBox([&](double x, double y) { return 64 + height(x, y); });
  EXPECT_NEAR(up.level - here.level, 64, 1e-9);
  EXPECT_NEAR(up.disagreement, here.disagreement, 1e-9);
  EXPECT_NEAR(up.dry_difference, here.dry_difference, 1e-6);
}

}  // namespace
}  // namespace tilemend
