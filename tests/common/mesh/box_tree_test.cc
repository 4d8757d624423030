#include "common/mesh/box_tree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

namespace tilemend {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::vector<AlignedBox3d> RandomBoxes(int count, double size, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto point = [&] { return Vector3d(share(random), share(random), share(random)); };
  std::vector<AlignedBox3d> boxes;
  for (int i = 0; i < count; ++i) {
    const Vector3d lo = point();
    boxes.emplace_back(lo, lo + size * point());
  }
  return boxes;
}

TEST(BoxTreeTest, FindsWhatMeetsABoxAndNothingElse) {
  for (const double size : {0.0, 0.02, 0.5}) {
    const std::vector<AlignedBox3d> boxes = RandomBoxes(500, size, 1);
    const BoxTree tree(boxes);
    for (const AlignedBox3d& wanted : RandomBoxes(50, 0.3, 2)) {
      std::multiset<int32_t> found, expected;
      tree.AnyMeeting(wanted, [&](int32_t i) {
        found.insert(i);
        return false;
      });
      for (size_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].intersects(wanted)) expected.insert(static_cast<int32_t>(i));
      }
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTreeTest, EndsAtTheFirstThatIsWanted) {
  const std::vector<AlignedBox3d> boxes(100, AlignedBox3d(Vector3d::Zero(), Vector3d::Ones()));
  int visits = 0;
  EXPECT_TRUE(BoxTree(boxes).AnyMeeting(boxes[0], [&](int32_t) { return ++visits == 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(BoxTreeTest, MayBeEmpty) {
  EXPECT_FALSE(BoxTree().AnyMeeting(AlignedBox3d(Vector3d::Zero(), Vector3d::Ones()), [](int32_t) { return true; }));
}

}  // namespace
}  // namespace tilemend
