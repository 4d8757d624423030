#include "coordinator/plan/water/verdict_chance.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Verdict = HoleEvidence::Verdict;

LevelEvidence RimWith(double disagreement, double dry_difference) {
  LevelEvidence evidence;
  evidence.windows = kMinWindows;
  evidence.disagreement = disagreement;
  evidence.dry_difference = dry_difference;
  return evidence;
}

TEST(ChanceOfErrorTest, IsHalfWhereTheTestTurns) {
  for (const Verdict verdict : {Verdict::kLake, Verdict::kNoWater}) {
    EXPECT_DOUBLE_EQ(ChanceOfError(verdict, RimWith(0.5, 1)), 0.5);
  }
}

TEST(ChanceOfErrorTest, FallsAwayFromThereOnTheVerdictsOwnSide) {
  EXPECT_DOUBLE_EQ(ChanceOfError(Verdict::kLake, RimWith(0.05, 1)), 0.0025 / 0.2525);
  EXPECT_DOUBLE_EQ(ChanceOfError(Verdict::kNoWater, RimWith(5, 1)), 0.25 / 25.25);
  EXPECT_EQ(ChanceOfError(Verdict::kRiver, RimWith(0, 1)), 0);
}

// A verdict that follows from something else than the level is no surer than a coin at most.
TEST(ChanceOfErrorTest, IsNoMoreThanHalf) {
  EXPECT_EQ(ChanceOfError(Verdict::kNoWater, RimWith(0.05, 1)), 0.5);
  EXPECT_EQ(ChanceOfError(Verdict::kLevelGround, RimWith(5, 1)), 0.5);
  EXPECT_EQ(ChanceOfError(Verdict::kLevelGround, RimWith(0, 0)), 0.5);
}

TEST(ChanceOfErrorTest, ARimTooShortToTestIsACoin) {
  LevelEvidence few = RimWith(5, 1);
  few.windows = kMinWindows - 1;
  EXPECT_EQ(ChanceOfError(Verdict::kNoWater, few), 0.5);
}

}  // namespace
}  // namespace tilemend
