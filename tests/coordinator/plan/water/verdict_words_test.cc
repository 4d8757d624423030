#include "coordinator/plan/water/verdict_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using Verdict = HoleEvidence::Verdict;

Basin LevelBasin() {
  Basin basin;
  basin.area = 500;
  basin.evidence.windows = 40;
  basin.evidence.disagreement = 0.08;
  basin.evidence.dry_difference = 2.5;
  return basin;
}

TEST(ReasonForTest, SaysWhyItIsWater) {
  EXPECT_EQ(ReasonFor(Verdict::kLake, LevelBasin(), 0, kWaterProfiles[0]),
            "the far sides of the rim tell the same level within 0.08 m");
}

TEST(ReasonForTest, SaysWhyItIsLevelGroundOnly) {
  EXPECT_THAT(ReasonFor(Verdict::kLevelGround, LevelBasin(), 0, kWaterProfiles[0]), HasSubstr("smaller than 1000 m2"));
  Basin noisy = LevelBasin();
  noisy.area = 5000;
  noisy.evidence.dry_difference = 0.05;
  noisy.evidence.noise = 0.1;
  EXPECT_EQ(
      ReasonFor(Verdict::kLevelGround, noisy, 0.25, kWaterProfiles[0]),
      "its rim is level within the noise of its heights: a dry surface would be 0.05 m off the level in the mean, "
      "less than three times the noise of 0.10 m; 25 % of the ground near it is as low; water has at most 17 %");
  EXPECT_EQ(
      ReasonFor(Verdict::kLake, noisy, 0, kWaterProfiles[0]),
      "its rim is level within the noise of its heights: a dry surface would be 0.05 m off the level in the mean, "
      "less than three times the noise of 0.10 m; no ground near it is as low");
}

TEST(ReasonForTest, SaysWhyItIsNoWater) {
  Basin basin = LevelBasin();
  EXPECT_EQ(ReasonFor(Verdict::kNoWater, basin, 0.3, kWaterProfiles[0]),
            "30 % of the ground near it is as low; water has at most 17 %");
  basin.evidence.disagreement = 1.7;
  EXPECT_EQ(ReasonFor(Verdict::kNoWater, basin, 1, kWaterProfiles[0]),
            "the far sides of the rim differ by 1.70 m in their level, and a dry surface by 2.50 m");
  basin.evidence.windows = 7;
  EXPECT_EQ(ReasonFor(Verdict::kNoWater, basin, 1, kWaterProfiles[0]),
            "too little of its rim tells a level: 7 places tell one, 20 are needed");
}

TEST(DecidedByTest, NamesTheArea) {
  WaterArea area;
  area.label = "'pond'";
  EXPECT_EQ(DecidedBy(area), "'pond' says that it is water");
  area.water = false;
  EXPECT_EQ(DecidedBy(area), "'pond' says that it is no water");
  area.label = "decision on hole 4";
  area.decision = ReviewDecision::kGround;
  EXPECT_EQ(DecidedBy(area), "your decision on hole 4: ground");
  area.decision = ReviewDecision::kWater;
  area.water = true;
  EXPECT_EQ(DecidedBy(area), "your decision on hole 4: water");
}

}  // namespace
}  // namespace tilemend
