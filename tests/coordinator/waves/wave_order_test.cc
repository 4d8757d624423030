#include "coordinator/waves/wave_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

struct Told {
  std::vector<std::string> phases, ends;
};

Told AllOf(const WaveOptions& options, int32_t layers) {
  Told told;
  for (WaveStep step; step.wave != Wave::kDone; step = After(step, options, layers)) {
    told.phases.push_back(PhaseOf(step, options, layers));
    if (const auto end = EndOf(step, options, layers); !end.empty()) told.ends.emplace_back(end);
  }
  told.phases.push_back(PhaseOf({Wave::kDone}, options, layers));
  return told;
}

TEST(WaveOrderTest, ThinPlateSamplesClustersAndThenLayers) {
  const Told told = AllOf({}, 2);
  EXPECT_THAT(told.phases, ElementsAre("measure levels", "survey", "ground", "plan", "sample clusters and fill",
                                       "sample layer 1 of 2", "sample layer 2 of 2", "fill", "smooth seams", "assemble",
                                       "assemble"));
  EXPECT_THAT(told.ends, ElementsAre("measure", "survey", "ground", "plan", "sample", "fill", "assemble"));
}

TEST(WaveOrderTest, WangFillsLayersAndSmooths) {
  WaveOptions options;
  options.surface = Surface::kWang;
  const Told told = AllOf(options, 1);
  EXPECT_THAT(told.phases[5], "fill layer 1 of 1");
  EXPECT_THAT(told.ends, ElementsAre("measure", "survey", "ground", "plan", "layers", "fill", "smooth", "assemble"));
}

TEST(WaveOrderTest, EndsWithThePlanIfThatIsAll) {
  WaveOptions options;
  options.plan_only = true;
  EXPECT_THAT(AllOf(options, 3).phases, ElementsAre("measure levels", "survey", "ground", "plan", "plan"));
}

TEST(WaveOrderTest, KeepsTheLastLayer) {
  EXPECT_EQ(After({Wave::kLayer, 3}, {}, 3).layer, 3);
  EXPECT_EQ(After({Wave::kFill, 3}, {}, 3).layer, 3);
}

TEST(WaveOptionsTest, WangFillsTheCellsAroundChosenOnesIfItSmooths) {
  WaveOptions options;
  options.chosen = {{1, 1}};
  EXPECT_TRUE(options.IsFilled({1, 1}));
  EXPECT_FALSE(options.IsFilled({2, 2}));
  options.surface = Surface::kWang;
  EXPECT_TRUE(options.IsFilled({2, 2}));
  EXPECT_FALSE(options.IsFilled({3, 1}));
  options.wang.seam_smoothing = 0;
  EXPECT_FALSE(options.IsFilled({2, 2}));
}

TEST(WaveOptionsTest, ASeamTouchesAChosenCellThatBothItsCellsTouch) {
  WaveOptions options;
  options.chosen = {{0, 0}};
  EXPECT_TRUE(options.TouchesChosen({1, 0}, {1, 1}));
  EXPECT_FALSE(options.TouchesChosen({1, 1}, {2, 1}));
}

}  // namespace
}  // namespace tilemend
