#include "coordinator/waves/cluster_sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/coordinator/waves/made_plan.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

// The patch of a closed hole may end at a seam of a cluster in the next cell.
TEST(ClusterSamplingTest, ACellAwaitsTheClustersWhoseVerticesItHas) {
  Plan plan = MadePlan();
  plan.vertices.resize(6);  // new ones, but 4
  plan.vertices[4].index = 7;
  plan.vertices[5].follows = 3;
  plan.holes[0].segments = {{0, 1}, {1, 4}};
  plan.holes[1].segments = {{1, 2}};
  plan.holes[2].segments = {{4, 4}};
  plan.holes[3].segments = {{3, 3}};
  const std::map<int32_t, std::vector<int32_t>> clusters = {{0, {0, 1}}, {1, {3}}};
  const auto await = [&] { return CellsThatAwait(plan, HolesToFill(plan, {}), clusters); };
  EXPECT_THAT(await(),
              ElementsAre(Pair(0, ElementsAre(CellId{0, 0}, CellId{1, 0})), Pair(1, ElementsAre(CellId{2, 0}))));
  plan.holes[2].own_regions = {{{4, 5}}};
  EXPECT_THAT(await().at(1), ElementsAre(CellId{1, 0}, CellId{2, 0})) << "it follows a vertex of that cluster";
  plan.holes[2].own_regions.clear();
  plan.holes[3].inner_edges = {{4, 0}};
  EXPECT_THAT(await().at(0), ElementsAre(CellId{0, 0}, CellId{1, 0}, CellId{2, 0}));
}

class ReleaseTest : public testing::Test {
 protected:
  ReleaseTest() : scene_{survey_} {
    scene_.plan = MadePlan();
    scene_.plan.vertices.resize(5);
    scene_.plan.holes[0].segments = {{0, 1}, {1, 0}};
    scene_.plan.holes[1].segments = {{1, 2}};
    scene_.plan.holes[3].segments = {{3, 4}, {4, 3}, {3, 3}, {4, 4}};
    scene_.holes_of = HolesToFill(scene_.plan, {});
  }

  const SceneSurvey survey_{Scene(), {}};
  PlannedScene scene_;
  SceneOutcome outcome_;
};

TEST_F(ReleaseTest, BeginsWithTheClusterOfMostSegments) {
  const ClusterSampling clusters(scene_);
  EXPECT_THAT(clusters.LargestFirst(scene_.plan), ElementsAre(1, 0));
  EXPECT_EQ(clusters.FirstCellOf(1, scene_.plan), (CellId{2, 0}));
}

TEST_F(ReleaseTest, ACellIsReleasedWithTheLastOfItsClusters) {
  scene_.plan.holes[2].inner_edges = {{2, 3}};  // the middle cell has a vertex of the other cluster
  ClusterSampling clusters(scene_);
  EXPECT_TRUE(clusters.IsAwaitedBy({1, 0}));
  EXPECT_FALSE(clusters.IsAwaitedBy({5, 5}));
  EXPECT_THAT(clusters.Release(1), ElementsAre(CellId{2, 0}));
  EXPECT_THAT(clusters.Release(0), ElementsAre(CellId{0, 0}, CellId{1, 0}));
}

TEST_F(ReleaseTest, TakesNoClusterOfWater) {
  scene_.plan.holes[3].water = 0;
  ClusterSampling clusters(scene_);
  EXPECT_THAT(clusters.LargestFirst(scene_.plan), ElementsAre(0));
  EXPECT_EQ(clusters.Take({1, {}, {}}, scene_, outcome_).message(), "cluster 1 is not in the plan");
}

}  // namespace
}  // namespace tilemend
