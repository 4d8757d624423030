#include "worker/papers/wang/cut_to_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::Le;
using ::testing::SizeIs;

struct Region {
  std::vector<LatticePoint> points;
  std::vector<RegionSegment> segments;

  // Counter-clockwise around the region, clockwise around an island.
  void Add(const std::vector<LatticePoint>& loop) {
    const auto first = static_cast<int32_t>(points.size()), n = static_cast<int32_t>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (int32_t i = 0; i < n; ++i) segments.push_back({first + i, first + (i + 1) % n});
  }
  CutRegion Cut(int32_t longest) const { return CutToLoops(TriangulateRegion(points, segments), points, longest); }
};

int64_t TwiceArea(const Region& region, const std::vector<int32_t>& loop) {
  int64_t area = 0;
  for (size_t i = 0; i < loop.size(); ++i) {
    const LatticePoint &a = region.points[loop[i]], &b = region.points[loop[(i + 1) % loop.size()]];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

int64_t TwiceArea(const Region& region, const CutRegion& cut) {
  return std::accumulate(cut.loops.begin(), cut.loops.end(), int64_t{0},
                         [&](int64_t sum, const auto& loop) { return sum + TwiceArea(region, loop); });
}

// A comb of teeth, not convex.
Region Comb(int64_t teeth) {
  std::vector<LatticePoint> loop = {{0, 0}, {20 * teeth, 0}};
  for (int64_t k = teeth; k-- > 0;) {
    for (const LatticePoint p : {LatticePoint{20 * k + 15, 100}, {20 * k + 10, 10}, {20 * k + 5, 90 + k}}) {
      loop.push_back(p);
    }
  }
  Region region;
  region.Add(loop);
  return region;
}

TEST(CutToLoopsTest, LeavesAShortLoopWhole) {
  const Region region = Comb(4);
  const CutRegion cut = region.Cut(14);
  EXPECT_EQ(cut.cuts, 0);
  ASSERT_THAT(cut.loops, SizeIs(1));
  EXPECT_THAT(cut.loops[0], SizeIs(14));
  EXPECT_EQ(TwiceArea(region, cut), TwiceArea(region, {cut.loops[0]}));
}

TEST(CutToLoopsTest, CutsALongLoopEvenly) {
  const Region region = Comb(50);
  const CutRegion cut = region.Cut(40);
  EXPECT_THAT(cut.loops, Each(SizeIs(Le(40))));
  EXPECT_EQ(cut.loops.size(), static_cast<size_t>(cut.cuts) + 1);
  EXPECT_LE(cut.cuts, 11) << "152 places in loops of at least a third of 40";
  EXPECT_EQ(TwiceArea(region, cut), TwiceArea(region, region.Cut(1000)));
  EXPECT_THAT(region.Cut(3).loops, SizeIs(150)) << "every triangle alone";
}

TEST(CutToLoopsTest, TiesIslandsToTheRest) {
  Region region;
  region.Add({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  region.Add({{20, 20}, {20, 30}, {30, 30}, {30, 20}});
  region.Add({{60, 60}, {60, 70}, {70, 70}, {70, 60}});
  const CutRegion cut = region.Cut(100);
  EXPECT_EQ(cut.cuts, 0);
  ASSERT_THAT(cut.loops, SizeIs(1));
  EXPECT_THAT(cut.loops[0], SizeIs(4 + 4 + 4 + 2 * 2)) << "each bridge is passed twice";
  EXPECT_EQ(TwiceArea(region, cut), 2 * (100 * 100 - 2 * 10 * 10));
}

// As the outline of a neighbour runs through a hole: from the boundary inward, over it, and nowhere near it.
TEST(CutToLoopsTest, PassesEdgesInsideOnBothSides) {
  Region region;
  region.Add({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  region.points.insert(region.points.end(), {{50, 50}, {60, 50}, {20, 80}, {30, 80}});
  for (const auto& [a, b] : {std::pair(0, 4), std::pair(4, 5), std::pair(6, 7)}) {
    region.segments.push_back({a, b});
    region.segments.push_back({b, a});
  }
  const CutRegion cut = region.Cut(100);
  ASSERT_THAT(cut.loops, SizeIs(1));
  EXPECT_THAT(cut.loops[0], SizeIs(4 + 2 * 3 + 2)) << "and a bridge";
  EXPECT_EQ(TwiceArea(region, cut), 2 * 100 * 100);
}

TEST(CutToLoopsTest, KeepsRegionsApart) {
  Region region;
  region.Add({{0, 0}, {10, 0}, {0, 10}});
  region.Add({{50, 50}, {60, 50}, {60, 60}, {50, 60}});
  const CutRegion cut = region.Cut(100);
  EXPECT_THAT(cut.loops, SizeIs(2));
  EXPECT_EQ(TwiceArea(region, cut), 100 + 200);
}

}  // namespace
}  // namespace tilemend
