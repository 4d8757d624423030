#include "coordinator/plan/pieces/open_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

// A tile of 10 m with two strips of surface over it from west to east, and a band of `width` metres without surface
// between them from y = 4 on. Runs: the northern rim of the southern strip (going west), the southern rim of the other.
struct River {
  explicit River(double width)
      : rim(RimOf({{{10, 4, 0}, {5, 4, 1}, {0, 4, 0}}, {{0, 4 + width, 0}, {5, 4 + width, 1}, {10, 4 + width, 0}}})),
        runs({{0, 1}, {3, 4}}) {}

  LinkedRuns Link() const { return LinkRuns(runs, rim, lines); }

  GridLines lines = LinesOf({{0, 0}}, 10);
  Rim rim;
  std::vector<std::vector<int32_t>> runs;
};

bool IsClosedWalk(const std::vector<RimSegment>& loop) {
  for (size_t k = 0; k < loop.size(); ++k) {
    if (loop[k].to != loop[(k + 1) % loop.size()].from) return false;
  }
  return !loop.empty();
}

TEST(LinkRunsTest, JoinsTheTwoBanksOfARiver) {
  const LinkedRuns linked = River(2).Link();
  ASSERT_EQ(linked.loops.size(), 1U);
  EXPECT_EQ(linked.loops[0].size(), 6U);
  EXPECT_TRUE(IsClosedWalk(linked.loops[0]));
  EXPECT_EQ(std::count_if(linked.loops[0].begin(), linked.loops[0].end(), [](const RimSegment& s) { return s.seam; }),
            2);
  ASSERT_EQ(linked.left.size(), 1U) << "the new outline";
  EXPECT_EQ(linked.left[0].edges, 2);
}

TEST(LinkRunsTest, JoinsThemWhateverTheirOrder) {
  River river(2);
  std::swap(river.runs[0], river.runs[1]);
  const LinkedRuns linked = river.Link();
  ASSERT_EQ(linked.loops.size(), 1U);
  EXPECT_TRUE(IsClosedWalk(linked.loops[0]));
}

TEST(LinkRunsTest, JoinsTheNearestEnds) {
  // Two rivers: each is closed by its own banks.
  const Rim rim = RimOf({{{10, 1, 0}, {5, 1, 0}, {0, 1, 0}},
                         {{0, 2, 0}, {5, 2, 0}, {10, 2, 0}},
                         {{10, 7, 0}, {5, 7, 0}, {0, 7, 0}},
                         {{0, 8, 0}, {5, 8, 0}, {10, 8, 0}}});
  const LinkedRuns linked = LinkRuns({{0, 1}, {9, 10}, {3, 4}, {6, 7}}, rim, LinesOf({{0, 0}}, 10));
  ASSERT_EQ(linked.loops.size(), 2U);
  for (const auto& loop : linked.loops) {
    EXPECT_TRUE(IsClosedWalk(loop));
    double lo = 10, hi = 0;
    for (const RimSegment& s : loop) {
      lo = std::min(lo, rim.points[s.from].position.y());
      hi = std::max(hi, rim.points[s.from].position.y());
    }
    EXPECT_EQ(hi - lo, 1);
  }
}

TEST(LinkRunsTest, LeavesARunThatFacesNoOther) {
  // From the west side, inside the tile and off every plane, to the south side.
  const Rim rim = RimOf({{{0, 4, 0}, {3, 3, 1}, {4, 0, 2}}});
  const LinkedRuns linked = LinkRuns({{0, 1}}, rim, LinesOf({{0, 0}}, 10));
  EXPECT_TRUE(linked.loops.empty());
  ASSERT_EQ(linked.left.size(), 1U);
  EXPECT_EQ(linked.left[0].edges, 2);
  EXPECT_NE(linked.left[0].reason.find("not known"), std::string::npos);
}

TEST(LinkRunsTest, JoinsNothingWithoutRuns) {
  const LinkedRuns linked = LinkRuns({}, Rim(), GridLines());
  EXPECT_TRUE(linked.loops.empty());
  EXPECT_TRUE(linked.left.empty());
}

}  // namespace
}  // namespace tilemend
