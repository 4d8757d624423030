#include "worker/papers/front/split_rim.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "common/mesh/triangle_shape.h"
#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

// Every third edge is three times as long as the others.
FrontRim UnevenRim() {
  FrontRim rim = FlatRim(48);
  FrontRim uneven;
  std::vector<int32_t> loop;
  for (size_t i = 0; i < rim.points.size(); ++i) {
    if (i % 6 == 1 || i % 6 == 2) continue;
    loop.push_back(static_cast<int32_t>(uneven.points.size()));
    uneven.points.push_back(rim.points[i]);
    uneven.areas.push_back(rim.areas[i]);
    uneven.neighbours.push_back(rim.neighbours[i]);
    uneven.sizes.push_back(1);
  }
  uneven.loops = {loop};
  const auto n = static_cast<int32_t>(loop.size());
  uneven.may_join = [n](int32_t a, int32_t b) {
    return a >= n || b >= n || (std::abs(a - b) != 1 && std::abs(a - b) != n - 1);
  };
  return uneven;
}

TEST(SplitRimTest, HalvesLongEdgesUntilNoneIs) {
  FrontRim rim = UnevenRim();
  const size_t before = rim.points.size();
  const int32_t split = SplitLongEdges(1.5, rim);
  EXPECT_EQ(split, 8);
  EXPECT_EQ(rim.points.size(), before + split);
  const std::vector<int32_t>& loop = rim.loops[0];
  EXPECT_EQ(loop.size(), before + split);
  for (size_t i = 0; i < loop.size(); ++i) {
    EXPECT_LE((rim.points[loop[i]] - rim.points[loop[(i + 1) % loop.size()]]).norm(), 1.5);
  }
}

TEST(SplitRimTest, LeavesAnEvenRim) {
  FrontRim rim = FlatRim(20);
  EXPECT_EQ(SplitLongEdges(1.5, rim), 0);
}

TEST(SplitRimTest, TiesAPatchBackToTheRimItself) {
  for (const double longest : {0.4, 1.5}) {
    FrontRim rim = UnevenRim();
    const std::vector<int32_t> loop = rim.loops[0];
    const auto count = static_cast<int32_t>(loop.size());
    const int32_t split = SplitLongEdges(longest, rim);
    FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
    ASSERT_TRUE(patch.closed());
    const size_t points = patch.points.size();
    ASSERT_TRUE(TieBack(count, split, rim.may_join, patch));
    EXPECT_EQ(patch.points.size(), points - split);
    std::map<std::pair<int32_t, int32_t>, int> uses;
    for (const Triangle& t : patch.triangles) {
      EXPECT_GT(TwiceVectorArea(patch.points, t).z(), 0);
      for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
    }
    for (int32_t i = 0; i < count; ++i) {
      EXPECT_EQ((uses[{loop[i], loop[(i + 1) % count]}]), 1);
      EXPECT_EQ(uses.count({loop[(i + 1) % count], loop[i]}), 0u);
    }
  }
}

}  // namespace
}  // namespace tilemend
