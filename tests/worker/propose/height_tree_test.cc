#include "worker/propose/height_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

constexpr int32_t kWall = SteppedHeights::kWall;

TEST(HeightTreeTest, TwoBasinsMeetWhereTheRidgeBetweenThemIs) {
  const SteppedHeights heights{7, 1, {9, 1, 1, 4, 2, 9, kWall}};
  const std::vector<HeightNode> nodes = HeightTreeOf(heights);
  ASSERT_EQ(nodes.size(), 4U);
  EXPECT_EQ(nodes[0].level, 1);
  EXPECT_EQ(nodes[0].area, 2);
  EXPECT_EQ(nodes[1].level, 2);
  EXPECT_EQ(nodes[1].area, 1);
  EXPECT_EQ(nodes[2].area, 4);
  EXPECT_EQ(nodes[0].parent, 2);
  EXPECT_EQ(nodes[1].parent, 2);
  EXPECT_EQ(nodes[2].parent, 3);
  EXPECT_EQ(nodes[3].area, 6);
  EXPECT_EQ(nodes[3].deep, 4) << "5 steps or more below 9";
  EXPECT_EQ(nodes[3].parent, -1);
  EXPECT_THAT(SquaresBelow(heights, nodes[0].square, 3), ElementsAre(1, 2));
  EXPECT_THAT(SquaresBelow(heights, nodes[0].square, 4), ElementsAre(1, 2, 3, 4));
}

// Against what each node says of itself.
TEST(HeightTreeTest, NodesAreWhatASearchFinds) {
  std::mt19937 random(3);
  for (int k = 0; k < 20; ++k) {
    SteppedHeights heights{12, 9, {}};
    for (int i = 0; i < 12 * 9; ++i) {
      const auto height = static_cast<int32_t>(random() % 14) - 7;
      heights.steps.push_back(height == 6 ? kWall : height);
    }
    const std::vector<HeightNode> nodes = HeightTreeOf(heights);
    for (const HeightNode& node : nodes) {
      const std::vector<int32_t> squares = SquaresBelow(heights, node.square, node.level);
      EXPECT_EQ(node.area, static_cast<int64_t>(squares.size()));
      EXPECT_EQ(node.deep, std::count_if(squares.begin(), squares.end(),
                                         [&](int32_t s) { return heights.steps[s] <= node.level - kDeepSteps; }));
      if (node.parent < 0) continue;
      EXPECT_GT(nodes[node.parent].level, node.level);
      EXPECT_EQ(SquaresBelow(heights, node.square, nodes[node.parent].level),
                SquaresBelow(heights, nodes[node.parent].square, nodes[node.parent].level));
      EXPECT_EQ(SquaresBelow(heights, node.square, nodes[node.parent].level - 1), squares);
    }
  }
}

TEST(HeightTreeTest, WallsAloneHaveNoNodes) { EXPECT_TRUE(HeightTreeOf({2, 1, {kWall, kWall}}).empty()); }

}  // namespace
}  // namespace tilemend
