#include "common/mesh/winding/wound_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

using Loops = std::vector<std::vector<LatticePoint>>;

struct Boundary {
  std::vector<LatticePoint> points;
  std::vector<DirectedEdge> segments;

  explicit Boundary(const Loops& loops) {
    for (const std::vector<LatticePoint>& loop : loops) {
      const auto base = static_cast<int32_t>(points.size()), n = static_cast<int32_t>(loop.size());
      points.insert(points.end(), loop.begin(), loop.end());
      for (int32_t k = 0; k < n; ++k) segments.push_back({base + k, base + (k + 1) % n});
    }
  }
};

std::vector<LatticePoint> AllPoints(const Boundary& boundary, const WoundRegion& region) {
  std::vector<LatticePoint> points = boundary.points;
  for (const RegionCorner& c : region.corners) points.push_back(c.place);
  return points;
}

// Twice the area that the region's boundary encloses.
int64_t DoubleArea(const Boundary& boundary, const WoundRegion& region) {
  const std::vector<LatticePoint> p = AllPoints(boundary, region);
  int64_t sum = 0;
  for (const DirectedEdge& s : region.segments) sum += p[s.from].x * p[s.to].y - p[s.from].y * p[s.to].x;
  return sum;
}

void ExpectSimple(const Boundary& boundary, const WoundRegion& region) {
  EXPECT_THAT(TriangulateRegion(AllPoints(boundary, region), region.segments).conflicts, IsEmpty());
}

TEST(WoundRegionTest, KeepsASimpleBoundaryAsItIs) {
  const Boundary square({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}});
  const WoundRegion region = FindWoundRegion(square.points, square.segments);
  EXPECT_THAT(region.corners, IsEmpty());
  EXPECT_EQ(DoubleArea(square, region), 2 * (100 - 9));
  EXPECT_THAT(LoopsBetween(square.segments, region.segments), IsEmpty());
}

TEST(WoundRegionTest, KeepsPointsAlongAStraightSide) {
  const Boundary square({{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}}});
  EXPECT_THAT(FindWoundRegion(square.points, square.segments).segments, SizeIs(5));
}

TEST(WoundRegionTest, CutsAFoldOffWhereTheBoundaryCrossesItself) {
  // The top side runs back and forth through itself: a small loop the wrong way round.
  const Boundary folded({{{0, 0}, {100, 0}, {100, 100}, {60, 100}, {40, 120}, {60, 120}, {40, 100}, {0, 100}}});
  const WoundRegion region = FindWoundRegion(folded.points, folded.segments);
  ExpectSimple(folded, region);
  ASSERT_THAT(region.corners, SizeIs(1));
  EXPECT_EQ(region.corners[0].place, (LatticePoint{50, 110}));
  EXPECT_THAT(region.corners[0].through, ElementsAre(3, 5));
  EXPECT_THAT(LoopsBetween(folded.segments, region.segments), ElementsAre(ElementsAre(3, 4, 5, 6, 8)))
      << "8: the crossing";
}

TEST(WoundRegionTest, TakesNoPartTwiceThatIsWoundAroundTwice) {
  const Boundary overlapping({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{4, 4}, {14, 4}, {14, 14}, {4, 14}}});
  const WoundRegion region = FindWoundRegion(overlapping.points, overlapping.segments);
  EXPECT_EQ(DoubleArea(overlapping, region), 2 * (100 + 100 - 36));
  ExpectSimple(overlapping, region);
}

TEST(WoundRegionTest, HasTheRestOfABoxOutside) {
  const Boundary square({{{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}});
  const LatticeBox box{{0, 0}, {20, 10}};
  const WoundRegion outside = FindWoundRegion(square.points, square.segments, box, Winding::kOutside);
  EXPECT_EQ(DoubleArea(square, outside), 2 * (200 - 25));
  const WoundRegion inside = FindWoundRegion(square.points, square.segments, box);
  EXPECT_EQ(DoubleArea(square, inside), 2 * 25);
  EXPECT_THAT(inside.corners, UnorderedElementsAre(::testing::Field(&RegionCorner::through, IsEmpty()),
                                                   ::testing::Field(&RegionCorner::through, SizeIs(1)),
                                                   ::testing::Field(&RegionCorner::through, SizeIs(1))));
}

TEST(WoundRegionTest, AFoldOfOneTakesNothingAwayFromTheOther) {
  // A hole that is wound around twice, under another square.
  const Boundary both({{{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                       {{20, 20}, {20, 50}, {50, 50}, {50, 20}},
                       {{20, 20}, {20, 50}, {50, 50}, {50, 20}},
                       {{10, 10}, {60, 10}, {60, 40}, {10, 40}}});
  const LatticeBox box{{0, 0}, {100, 100}};
  EXPECT_EQ(DoubleArea(both, FindWoundRegion(both.points, both.segments, box)), 2 * (10000 - 900));
  const WoundRegion united = UniteWoundRegions(both.points, both.segments, 12, box);
  EXPECT_EQ(DoubleArea(both, united), 2 * (10000 - 300));
  ExpectSimple(both, united);
  ASSERT_THAT(united.corners, SizeIs(2));
  for (const RegionCorner& c : united.corners) EXPECT_EQ(c.through.back(), 14) << "numbered as they were given";
  EXPECT_EQ(DoubleArea(both, UniteWoundRegions(both.points, both.segments, 16, box)), 2 * (10000 - 900)) << "all first";
  EXPECT_EQ(DoubleArea(both, UniteWoundRegions(both.points, both.segments, 12, {{0, 0}, {100, 30}})), 2 * 3000);
}

TEST(WoundRegionTest, ClosesAnOpenChainByAStraightWay) {
  Boundary square({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}});
  square.segments.pop_back();
  EXPECT_EQ(DoubleArea(square, FindWoundRegion(square.points, square.segments)), 200);
}

TEST(WoundRegionTest, TakesOfPointsAtOnePlaceThoseThatSegmentsJoin) {
  // A step seen from above: 2 and 3 lie at one place.
  const Boundary step({{{0, 0}, {10, 0}, {10, 10}, {10, 10}, {0, 10}}});
  const WoundRegion region = FindWoundRegion(step.points, step.segments);
  ASSERT_THAT(region.segments, SizeIs(4));
  EXPECT_THAT(LoopsBetween(step.segments, region.segments), ElementsAre(SizeIs(3))) << "the wall below the step";
}

TEST(WoundRegionTest, IsSimpleWhateverTheBoundary) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + round % 40;
    std::vector<LatticePoint> loop;
    for (int k = 0; k < n; ++k) {
      loop.push_back({static_cast<int64_t>(random() % 1000), static_cast<int64_t>(random() % 1000)});
    }
    const Boundary boundary({loop});
    const WoundRegion region = FindWoundRegion(boundary.points, boundary.segments);
    SCOPED_TRACE(round);
    ExpectSimple(boundary, region);
    EXPECT_GE(DoubleArea(boundary, region), 0);
  }
}

// On a coarse lattice most boundaries run along themselves.
TEST(WoundRegionTest, HasACornerAtEveryPointAlongItsBoundary) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    std::vector<LatticePoint> loop;
    for (int k = 0; k < 4 + round % 20; ++k) {
      loop.push_back({static_cast<int64_t>(random() % 7) * 10, static_cast<int64_t>(random() % 7) * 10});
    }
    const Boundary boundary({loop});
    const WoundRegion region = FindWoundRegion(boundary.points, boundary.segments);
    const std::vector<LatticePoint> p = AllPoints(boundary, region);
    for (const DirectedEdge& s : region.segments) {
      const auto [a, b] = std::minmax(p[s.from], p[s.to]);
      for (const LatticePoint& q : boundary.points) {
        EXPECT_FALSE(a < q && q < b && Orientation(a, b, q) == 0) << round << ": " << q.x << ", " << q.y;
      }
    }
  }
}

TEST(LoopsBetweenTest, EndWhereTheyMeetThemselves) {
  // Two triangles that share vertex 2, both left out of the inner boundary.
  const std::vector<DirectedEdge> outer = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 2}, {2, 0}};
  EXPECT_THAT(LoopsBetween(outer, {}), UnorderedElementsAre(SizeIs(3), SizeIs(3)));
}

TEST(LoopsBetweenTest, HoldTheBoundaryTogether) {
  // 1 -> 2 -> 3 is cut off by 1 -> 3.
  const std::vector<DirectedEdge> outer = {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, inner = {{0, 1}, {1, 3}, {3, 0}};
  EXPECT_THAT(LoopsBetween(outer, inner), ElementsAre(ElementsAre(1, 2, 3)));
}

}  // namespace
}  // namespace tilemend
