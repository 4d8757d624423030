#include "coordinator/waves/scene_outcome.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

Plan PlanOf(size_t holes) {
  Plan plan;
  plan.holes.resize(holes);
  return plan;
}

TEST(SceneOutcomeTest, CountsTheTrianglesOfHolesThatAreFilledWhole) {
  SceneOutcome outcome;
  ASSERT_TRUE(outcome.Add({{0, 0}, {{{3, "", 10, 20, {}}, {4, "", 10, 7, {}}}, {}}}, PlanOf(5)).ok());
  EXPECT_EQ(outcome.triangles, 27);
  ASSERT_TRUE(outcome.Add({{0, 0}, {{{3, "no way", 0, 0, {}}}, {}}}, PlanOf(5)).ok());
  EXPECT_EQ(outcome.triangles, 7);
  EXPECT_EQ(outcome.failures.at(3), "no way");
  outcome.Fail(4, "the worker broke");
  EXPECT_EQ(outcome.triangles, 0);
  EXPECT_TRUE(outcome.sizes.empty());
}

TEST(SceneOutcomeTest, AddsUpTheTwoPatchesOfAHole) {
  SceneOutcome outcome;
  ASSERT_TRUE(outcome.Add({{0, 0}, {{{0, "", 10, 20, {}}, {0, "", 1, 2, {}}}, {}}}, PlanOf(1)).ok());
  EXPECT_EQ(outcome.sizes.at(0).new_vertices, 11);
  EXPECT_EQ(outcome.sizes.at(0).triangles, 22);
}

TEST(SceneOutcomeTest, KnowsTheCellsWithAPatch) {
  SceneOutcome outcome;
  ASSERT_TRUE(outcome.Add({{0, 0}, {{{0, "", 1, 2, {}}}, {}}}, PlanOf(2)).ok());
  ASSERT_TRUE(outcome.Add({{1, 0}, {{{1, "no way", 0, 0, {}}}, {}}}, PlanOf(2)).ok());
  EXPECT_EQ(outcome.filled, (std::set<CellId>{{0, 0}}));
}

TEST(SceneOutcomeTest, TilesThatAreNotWrittenHaveNoQualityAndNoGaps) {
  SceneOutcome outcome;
  CellPatches patches{{{0, "", 1, 2, {}}}, {}};
  patches.quality.Add(0.5, false);
  ASSERT_TRUE(outcome.Add({{0, 0}, patches}, PlanOf(1)).ok());
  patches.quality.Add(0.1, true);
  ASSERT_TRUE(outcome.Add({{1, 0}, patches}, PlanOf(1)).ok());
  EXPECT_EQ(outcome.Quality().triangles, 3);
  outcome.DropTile({{1, 0}, "disk"});
  EXPECT_EQ(outcome.Quality().triangles, 1);
  EXPECT_EQ(outcome.Quality().least, 0.5);
  outcome.SetGaps({{{{0, 0}, {1, 0}}, {}}, {{{0, 0}, {0, 1}}, {}}});
  ASSERT_EQ(outcome.fill_gaps.size(), 1U);
  EXPECT_EQ(outcome.fill_gaps.begin()->first.second, (CellId{0, 1}));
}

TEST(SceneOutcomeTest, RefusesAHoleThatIsNotInThePlan) {
  SceneOutcome outcome;
  for (const int32_t hole : {-1, 2}) {
    EXPECT_TRUE(absl::IsInvalidArgument(outcome.Add({{0, 0}, {{{hole, "", 1, 2, {}}}, {}}}, PlanOf(2))));
  }
  EXPECT_TRUE(outcome.sizes.empty());
}

}  // namespace
}  // namespace tilemend
