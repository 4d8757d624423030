#include "worker/fill/space/loop_bridges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Two squares one beside the other: 0 to 3 from (0, 0), 4 to 7 from (3, 0), counter-clockwise.
Point3 At(int32_t v) {
  const Point3 corner(v < 4 ? 0 : 3, 0, 0);
  constexpr double kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
  return corner + Point3(kX[v % 4], kY[v % 4], 0);
}

const std::vector<VertexLoop> kSquares = {{0, 1, 2, 3}, {4, 5, 6, 7}};

TEST(LoopBridgesTest, TheShortestComesFirst) {
  const std::vector<Bridge> bridges = BridgesFrom({At, [](int32_t, int32_t) { return true; }}, kSquares);
  ASSERT_EQ(bridges.size(), 16U);
  EXPECT_EQ(bridges[0].from, 1U);
  EXPECT_EQ(bridges[0].loop, 1U);
  EXPECT_EQ(bridges[0].to, 0U);
  EXPECT_EQ(bridges[0].length, 2);
  for (size_t k = 1; k < bridges.size(); ++k) EXPECT_LE(bridges[k - 1].length, bridges[k].length);
}

TEST(LoopBridgesTest, AreBuiltWhereTheyMayBe) {
  const std::vector<Bridge> bridges =
      BridgesFrom({At, [](int32_t a, int32_t b) { return a == 3 && b == 5; }}, kSquares);
  ASSERT_EQ(bridges.size(), 1U);
  EXPECT_EQ(bridges[0].length, std::hypot(4, 1));
  EXPECT_THAT(BridgesFrom({At, [](int32_t, int32_t) { return false; }}, kSquares), IsEmpty());
}

TEST(LoopBridgesTest, LeadAroundBothLoops) {
  std::vector<VertexLoop> loops = kSquares;
  EXPECT_TRUE(BuildBridge({1, 1, 2, 0}, loops));
  EXPECT_THAT(loops, ElementsAre(ElementsAre(0, 1, 6, 7, 4, 5, 6, 1, 2, 3)));
}

TEST(LoopBridgesTest, NeedNoWayAtACommonVertex) {
  std::vector<VertexLoop> loops = {{0, 1, 2, 3}, {5, 6, 1}};
  EXPECT_FALSE(BuildBridge({1, 1, 2, 0}, loops));
  EXPECT_THAT(loops, ElementsAre(ElementsAre(0, 1, 5, 6, 1, 2, 3)));
}

}  // namespace
}  // namespace tilemend
