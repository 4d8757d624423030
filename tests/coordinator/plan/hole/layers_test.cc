#include "coordinator/plan/hole/layers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using Pairs = std::vector<std::pair<int32_t, int32_t>>;

TEST(LayerHolesTest, NumbersLayersByTheDistanceFromTheOutermostHoles) {
  const Layering result = LayerHoles({true, true, true, true, true}, {true, false, false, false, true},
                                     Pairs{{0, 1}, {1, 2}, {2, 3}, {3, 4}});
  EXPECT_THAT(result.layer, ElementsAre(1, 2, 3, 2, 1));
  EXPECT_EQ(result.layers, 3);
}

TEST(LayerHolesTest, PutsHolesThatTouchThroughOthersIntoOneCluster) {
  const Layering result =
      LayerHoles({true, true, true, true, true}, {true, true, true, true, true}, Pairs{{4, 2}, {2, 0}, {3, 1}});
  EXPECT_THAT(result.cluster, ElementsAre(0, 1, 0, 1, 0));
  EXPECT_EQ(result.clusters, 2);
}

TEST(LayerHolesTest, LeavesClosedHolesOutOfClustersAndLayers) {
  const Layering result = LayerHoles({false, true, false}, {true, true, true}, Pairs{});
  EXPECT_THAT(result.cluster, ElementsAre(-1, 0, -1));
  EXPECT_THAT(result.layer, ElementsAre(0, 1, 0));
}

TEST(LayerHolesTest, StartsAClusterWithoutSurfaceAtItsLowestHole) {
  const Layering result = LayerHoles({true, true, true, true}, {true, false, false, false}, Pairs{{2, 3}, {1, 2}});
  EXPECT_THAT(result.layer, ElementsAre(1, 1, 2, 3));
}

TEST(LayerHolesTest, CountsTheLayersOfEachClusterFromOne) {
  const Layering result = LayerHoles({true, true, true, true}, {true, false, false, true}, Pairs{{0, 1}, {2, 3}});
  EXPECT_THAT(result.layer, ElementsAre(1, 2, 2, 1));
}

TEST(LayerHolesTest, HasNoLayersWithoutOpenHoles) {
  const Layering result = LayerHoles({false, false}, {true, true}, Pairs{});
  EXPECT_EQ(result.clusters, 0);
  EXPECT_EQ(result.layers, 0);
}

}  // namespace
}  // namespace tilemend
