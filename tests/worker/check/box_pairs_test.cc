#include "worker/check/box_pairs.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using Pairs = std::set<std::pair<int32_t, int32_t>>;

std::vector<Eigen::AlignedBox3d> RandomBoxes(int count, double size, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d lo(place(random), place(random), place(random));
    boxes.emplace_back(lo, lo + size * Eigen::Vector3d(place(random), place(random), place(random)));
  }
  return boxes;
}

Pairs PairsOf(const std::vector<Eigen::AlignedBox3d>& boxes) {
  Pairs pairs;
  ForBoxPairs(boxes, [&](int32_t a, int32_t b) {
    EXPECT_LT(a, b);
    EXPECT_TRUE(pairs.emplace(a, b).second) << a << " and " << b << " again";
  });
  return pairs;
}

TEST(ForBoxPairsTest, FindsWhatComparingAllFinds) {
  for (const double size : {0.01, 0.1, 2.0}) {
    const std::vector<Eigen::AlignedBox3d> boxes = RandomBoxes(600, size, 7);
    Pairs expected;
    for (int32_t a = 0; a < 600; ++a) {
      for (int32_t b = a + 1; b < 600; ++b) {
        if (boxes[a].intersects(boxes[b])) expected.emplace(a, b);
      }
    }
    EXPECT_EQ(PairsOf(boxes), expected) << size;
  }
}

TEST(ForBoxPairsTest, EndsOnBoxesThatAllOverlap) {
  const std::vector<Eigen::AlignedBox3d> boxes(300, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()});
  EXPECT_EQ(PairsOf(boxes).size(), 300u * 299u / 2);
}

}  // namespace
}  // namespace tilemend
