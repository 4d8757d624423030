#include "worker/fill/space/rim_junctions.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

LocalHole LoopOf(const std::vector<Point3>& corners) {
  LocalHole hole;
  hole.positions = corners;
  const auto n = static_cast<int32_t>(corners.size());
  for (int32_t i = 0; i < n; ++i) hole.segments.push_back({i, (i + 1) % n});
  return hole;
}

TEST(HasJunctionTest, FindsAVertexOnAnEdge) {
  EXPECT_TRUE(HasJunction(LoopOf({{0, 0, 0}, {1, 2, 3}, {0.5, 1, 1.5}})));
  EXPECT_FALSE(HasJunction(LoopOf({{0, 0, 0}, {1, 2, 3}, {0.5, 1, 1.502}})));
  EXPECT_TRUE(HasJunction(LoopOf({{0, 0, 0}, {1, 2, 3}, {0.5, 1, 1.5000001}})));  // rounded
  EXPECT_FALSE(HasJunction(LoopOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})));
  EXPECT_TRUE(HasJunction(LoopOf({{0, 0, 0}, {2, 0, 0}, {3, 3, 0}, {1, 0, 0}, {-1, 3, 0}})));
}

}  // namespace
}  // namespace tilemend
