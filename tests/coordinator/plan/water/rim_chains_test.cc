#include "coordinator/plan/water/rim_chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "coordinator/plan/water/hole_groups.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::SizeIs;

Plan PlanOf(const SceneMakerOptions& scene) { return MakePlan(SurveyScene(MakeScene(scene)).Input(), {}); }

// Of nine cells, whose borders cut it: the rim of a hole is one chain around it, without seams.
TEST(RimChainsTest, LinksTheRimOverBordersOfCells) {
  const Plan plan = PlanOf(LakeOverNineCells(Cut::kClipped));
  const std::vector<std::vector<int32_t>> groups = GroupHoles(plan);
  ASSERT_THAT(groups, SizeIs(1));
  const std::vector<RimChain> chains = RimChainsOf(plan, groups[0]);
  ASSERT_THAT(chains, SizeIs(1));
  double length = 0;
  size_t far = 0;
  for (size_t i = 0; i < chains[0].size(); ++i) {
    length += chains[0][i].length;
    if (i > 0 && (chains[0][i].middle - chains[0][i - 1].middle).norm() > 6) ++far;
  }
  EXPECT_EQ(far, 0U);
  EXPECT_GT(length, 300);
  EXPECT_LT(length, 500);
}

TEST(RimChainsTest, AChainAroundAHoleBeginsAtTheSameEdgeWhereverTheWalkBegins) {
  Plan plan;
  plan.vertices.resize(4);
  for (int32_t v = 0; v < 4; ++v) {
    plan.vertices[v].position = Point3(v == 1 || v == 2, v > 1, 1);
    plan.vertices[v].index = v;
  }
  plan.holes.resize(1);
  for (int32_t first = 0; first < 4; ++first) {
    std::vector<RimSegment>& segments = plan.holes[0].segments;
    segments.clear();
    for (int32_t k = 0; k < 4; ++k) segments.push_back({(first + k) % 4, (first + k + 1) % 4, false});
    const std::vector<RimChain> chains = RimChainsOf(plan, {0});
    ASSERT_THAT(chains, SizeIs(1));
    EXPECT_EQ(chains[0][0].middle, Point3(0, 0.5, 1));
  }
}

TEST(RimChainsTest, SeamsAndNewVerticesAreInNone) {
  Plan plan;
  plan.vertices.resize(4);
  for (int32_t v = 0; v < 4; ++v) plan.vertices[v].position = Point3(v, 0, 1), plan.vertices[v].index = v < 3 ? v : -1;
  plan.holes.resize(1);
  plan.holes[0].segments = {{0, 1, false}, {1, 2, true}, {2, 3, false}};
  const std::vector<RimChain> chains = RimChainsOf(plan, {0});
  ASSERT_THAT(chains, SizeIs(1));
  ASSERT_THAT(chains[0], SizeIs(1));
  EXPECT_EQ(chains[0][0].middle, Point3(0.5, 0, 1));
  EXPECT_EQ(chains[0][0].length, 1);
}

}  // namespace
}  // namespace tilemend
