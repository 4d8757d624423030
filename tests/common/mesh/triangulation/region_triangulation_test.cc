#include "common/mesh/triangulation/region_triangulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/common/mesh/triangulation/region_checks.h"

namespace tilemend {
namespace {

using testing::BoundedArea2;
using testing::CheckDelaunay;
using testing::CheckTopology;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::RandomStar;
using testing::Region;
using testing::Square;
using testing::TriangulateAndCheck;
using Kind = RegionConflict::Kind;

std::vector<Kind> Kinds(const RegionTriangulation& result) {
  std::vector<Kind> kinds;
  for (const RegionConflict& c : result.conflicts) kinds.push_back(c.kind);
  return kinds;
}

// Triangulates and expects conflicts of one kind first, and nothing else in the result.
RegionConflict FirstConflict(const Region& region) {
  const RegionTriangulation result = TriangulateRegion(region.points, region.segments);
  EXPECT_THAT(result.conflicts, Not(IsEmpty()));
  EXPECT_THAT(result.triangles, IsEmpty());
  EXPECT_THAT(result.neighbors, IsEmpty());
  EXPECT_THAT(result.segment_triangle, IsEmpty());
  EXPECT_EQ(result.component_count, 0);
  return result.conflicts.empty() ? RegionConflict{} : result.conflicts[0];
}

TEST(TriangulateRegionTest, NothingGivesNothing) {
  const RegionTriangulation result = TriangulateRegion({}, {});
  EXPECT_THAT(result.conflicts, IsEmpty());
  EXPECT_THAT(result.triangles, IsEmpty());
}

TEST(TriangulateRegionTest, PointsWithoutSegmentsGiveNothing) {
  const std::vector<LatticePoint> points = {{0, 0}, {5, 0}, {0, 5}, {0, 0}};
  EXPECT_THAT(TriangulateRegion(points, {}).triangles, IsEmpty());
  EXPECT_THAT(TriangulateRegion(points, {}).conflicts, IsEmpty());
}

TEST(TriangulateRegionTest, EndsAtTheSegmentWhereItIsCancelled) {
  const Region region = RandomStar(1, 100, 1000);
  const auto count = static_cast<int>(region.segments.size());
  for (const int last : {0, 1, count / 2, count - 1, count}) {
    int asked = 0;
    const auto result = TriangulateRegion(region.points, region.segments, [&] { return asked++ == last; });
    const bool is_whole = last == count;
    EXPECT_EQ(asked, is_whole ? count : last + 1);
    EXPECT_EQ(Kinds(result), is_whole ? std::vector<Kind>() : std::vector{Kind::kCancelled}) << last;
    EXPECT_EQ(result.triangles.empty(), !is_whole) << last;
  }
}

TEST(TriangulateRegionTest, TriangleStaysOne) {
  const auto result = TriangulateAndCheck(Region().Loop({{0, 0}, {10, 0}, {3, 7}}));
  EXPECT_EQ(result.triangles.size(), 1u);
  EXPECT_EQ(result.component_count, 1);
}

TEST(TriangulateRegionTest, SquareWithIslands) {
  Region region = Square(0, 0, 1000);
  region.Loop({{100, 100}, {100, 300}, {300, 300}, {300, 100}});  // clockwise
  region.Loop({{600, 600}, {650, 800}, {800, 650}});
  const auto result = TriangulateAndCheck(region);
  EXPECT_EQ(result.triangles.size(), 11u + 2);
  EXPECT_EQ(result.component_count, 1);
}

TEST(TriangulateRegionTest, RegionInsideAnIslandIsAnotherComponent) {
  Region region = Square(0, 0, 1000);
  region.Loop({{100, 100}, {100, 900}, {900, 900}, {900, 100}});
  region.Loop({{300, 300}, {700, 300}, {700, 700}, {300, 700}});
  const auto result = TriangulateAndCheck(region);
  EXPECT_EQ(result.component_count, 2);
  EXPECT_EQ(result.component[result.segment_triangle[0]], 0);
  EXPECT_EQ(result.component[result.segment_triangle[11]], 1);
}

TEST(TriangulateRegionTest, ComponentsAreNumberedByTheirFirstSegment) {
  Region region;
  for (int i = 4; i >= 0; --i) region.Loop({{100 * i, 0}, {100 * i + 50, 0}, {100 * i, 50}});
  const auto result = TriangulateAndCheck(region);
  ASSERT_EQ(result.component_count, 5);
  for (int s = 0; s < 15; ++s) EXPECT_EQ(result.component[result.segment_triangle[s]], s / 3);
}

TEST(TriangulateRegionTest, TwoTrianglesPinchedAtAVertex) {
  Region region;
  region.points = {{0, 0}, {10, -5}, {10, 5}, {-10, 5}, {-10, -5}};
  region.LoopOf({0, 1, 2, 0, 3, 4});
  const auto result = TriangulateAndCheck(region);
  EXPECT_EQ(result.triangles.size(), 2u);
  EXPECT_EQ(result.component_count, 2);
}

TEST(TriangulateRegionTest, IslandTouchesTheBoundaryAtAVertex) {
  Region region = Square(0, 0, 100);
  region.points.push_back({50, 50});
  region.points.push_back({30, 60});
  region.LoopOf({0, 5, 4});
  TriangulateAndCheck(region);
}

TEST(TriangulateRegionTest, IslandTouchesTheBoundaryAtTwoVerticesAndSplitsTheRegion) {
  Region region = Square(0, 0, 100);
  region.points.push_back({50, 40});
  region.points.push_back({50, 60});
  region.LoopOf({0, 5, 2, 4});
  const auto result = TriangulateAndCheck(region);
  EXPECT_EQ(result.component_count, 2);
}

TEST(TriangulateRegionTest, ManyPinchesAtOneVertex) {
  Region region;
  region.points.push_back({0, 0});
  const int count = 200;
  for (int i = 0; i < count; ++i) {
    for (double part : {0.0, 0.5}) {
      const double angle = 2 * std::numbers::pi * (i + part) / count;
      region.points.push_back({std::llround(1e6 * std::cos(angle)), std::llround(1e6 * std::sin(angle))});
    }
    region.LoopOf({0, 2 * i + 1, 2 * i + 2});
  }
  EXPECT_EQ(TriangulateAndCheck(region).component_count, count);
}

TEST(TriangulateRegionTest, BothDirectionsOfASegmentSeparateTwoRegions) {
  Region region = Square(0, 0, 100);
  region.segments.push_back({0, 2});
  region.segments.push_back({2, 0});
  EXPECT_EQ(TriangulateAndCheck(region).component_count, 2);
}

TEST(TriangulateRegionTest, SlitInsideARegion) {
  Region region = Square(0, 0, 100);
  region.points.push_back({20, 50});
  region.points.push_back({80, 55});
  region.segments.push_back({4, 5});
  region.segments.push_back({5, 4});
  EXPECT_EQ(TriangulateAndCheck(region).component_count, 1);
}

TEST(TriangulateRegionTest, CollinearPointsAlongGridBorders) {
  std::vector<LatticePoint> loop;
  const int n = 500;
  for (int i = 0; i < n; ++i) loop.push_back({i * 1000, 0});
  for (int i = 0; i < n; ++i) loop.push_back({n * 1000, i * 1000});
  for (int i = 0; i < n; ++i) loop.push_back({(n - i) * 1000, n * 1000});
  for (int i = 0; i < n; ++i) loop.push_back({0, (n - i) * 1000});
  EXPECT_EQ(TriangulateAndCheck(Region().Loop(loop)).triangles.size(), 4u * n - 2);
}

TEST(TriangulateRegionTest, NearlyCollinearPointsAlongAThinRegion) {
  std::mt19937 random(5);
  for (int64_t wobble : {1, 10, 100}) {
    std::uniform_int_distribution<int64_t> off(-wobble, wobble);
    std::vector<LatticePoint> loop;
    const int n = 2000;
    for (int i = 0; i < n; ++i) loop.push_back({i * 100'000, off(random)});
    for (int i = n; i > 0; --i) loop.push_back({i * 100'000 + off(random), 2 * wobble + 1 + off(random)});
    TriangulateAndCheck(Region().Loop(loop));
  }
}

TEST(TriangulateRegionTest, OneLongEdgeAgainstManyShortOnes) {
  std::vector<LatticePoint> loop = {{0, 0}, {100'000'000, 0}};
  std::mt19937 random(6);
  std::uniform_int_distribution<int64_t> height(1, 100'000);
  for (int i = 3000; i >= 0; --i) loop.push_back({i * 33'333, height(random)});
  TriangulateAndCheck(Region().Loop(loop));
}

TEST(TriangulateRegionTest, HubOfAFan) {
  std::vector<LatticePoint> loop = {{0, 0}};
  const int n = 3000;
  for (int i = 0; i <= n; ++i) {
    const double angle = std::numbers::pi / 2 * i / n;
    loop.push_back({std::llround(2e8 * std::cos(angle)), std::llround(2e8 * std::sin(angle))});
  }
  TriangulateAndCheck(Region().Loop(loop));
}

TEST(TriangulateRegionTest, Spiral) {
  std::vector<LatticePoint> loop;
  const int n = 1500;  // almost five turns, 6.3e6 apart
  const auto add = [&](int i, double width) {
    const double turn = 0.02 * i, radius = 4e6 + 2e4 * i - width;
    loop.push_back({std::llround(radius * std::cos(turn)), std::llround(radius * std::sin(turn))});
  };
  for (int i = 0; i < n; ++i) add(i, 0);
  for (int i = n - 1; i >= 0; --i) add(i, 2e6);
  EXPECT_EQ(TriangulateAndCheck(Region().Loop(loop)).triangles.size(), 2u * n - 2);
}

TEST(TriangulateRegionTest, RandomStarsHaveTheirExactAreaAndAreDelaunay) {
  for (uint32_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    TriangulateAndCheck(
        RandomStar(seed, 3 + static_cast<int>(seed % 97), seed % 3 == 0 ? 300.0 * (1 + seed % 97) : 2e8));
    if (HasFatalFailure()) return;
  }
}

TEST(TriangulateRegionTest, FreePointsInsideAreInserted) {
  Region region = Square(0, 0, 1000);
  region.Loop({{400, 400}, {400, 600}, {600, 600}, {600, 400}});
  for (LatticePoint p : {LatticePoint{100, 100}, {500, 500}, {2000, 5}, {500, 0}, {0, 0}, {100, 100}, {200, 300}}) {
    region.points.push_back(p);  // inside; in the island; outside; on a segment; on a vertex; twice; inside
  }
  EXPECT_EQ(TriangulateAndCheck(region).triangles.size(), 8u + 2 * 2);
}

TEST(TriangulateRegionTest, ManyFreePointsStayDelaunay) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int64_t> draw(-260, 260);  // dense: many coincident, collinear, cocircular
  Region region = RandomStar(4, 40, 250);
  for (int i = 0; i < 20'000; ++i) region.points.push_back({draw(random), draw(random)});
  TriangulateAndCheck(region);
}

TEST(TriangulateRegionTest, MovingAndTurningChangesNothingButThePlace) {
  const Region region = RandomStar(8, 300, 1e8);
  const auto base = TriangulateAndCheck(region);
  Region moved = region;
  for (LatticePoint& p : moved.points) p = {p.x + 12345, p.y - 100'000'000};
  EXPECT_EQ(TriangulateAndCheck(moved).triangles, base.triangles);
  Region turned = region;
  for (LatticePoint& p : turned.points) p = {-p.y, p.x};
  const auto sorted = [](const RegionTriangulation& r) {
    std::vector<Triangle> triangles = r.triangles;
    for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  };
  EXPECT_EQ(sorted(TriangulateAndCheck(turned)), sorted(base));
}

TEST(TriangulateRegionTest, IsDeterministic) {
  const Region region = RandomStar(9, 500, 1e8);
  const auto a = TriangulateRegion(region.points, region.segments);
  const auto b = TriangulateRegion(region.points, region.segments);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.neighbors, b.neighbors);
}

TEST(RegionConflictTest, CoincidentPoints) {
  Region region = Square(0, 0, 10);
  region.Loop({{10, 10}, {20, 10}, {20, 20}});
  const RegionConflict conflict = FirstConflict(region);
  EXPECT_EQ(conflict.kind, Kind::kCoincidentPoints);
  EXPECT_EQ(conflict.first, 2);
  EXPECT_EQ(conflict.second, 4);
}

TEST(RegionConflictTest, CrossingSegments) {
  const RegionConflict conflict = FirstConflict(Region().Loop({{0, 0}, {10, 10}, {10, 0}, {0, 10}}));
  EXPECT_EQ(conflict.kind, Kind::kCrossing);
  EXPECT_EQ(conflict.first, 0);
  EXPECT_EQ(conflict.second, 2);
}

TEST(RegionConflictTest, CrossingLoops) {
  Region region = Square(0, 0, 100);
  region.Loop({{50, 50}, {150, 50}, {150, 150}, {50, 150}});
  const auto result = TriangulateRegion(region.points, region.segments);
  EXPECT_THAT(Kinds(result), ::testing::ElementsAre(Kind::kCrossing, Kind::kCrossing));
}

TEST(RegionConflictTest, PointOnSegment) {
  Region region = Square(0, 0, 100);
  region.Loop({{50, 0}, {60, 50}, {70, 50}});
  const RegionConflict conflict = FirstConflict(region);
  EXPECT_EQ(conflict.kind, Kind::kPointOnSegment);
  EXPECT_EQ(conflict.first, 0);
  EXPECT_EQ(conflict.second, 4);
}

TEST(RegionConflictTest, OverlappingSegments) {
  Region region = Square(0, 0, 100);
  region.Loop({{40, 0}, {60, 0}, {50, -50}});
  EXPECT_EQ(FirstConflict(region).kind, Kind::kPointOnSegment);
}

TEST(RegionConflictTest, DegenerateSegments) {
  Region region = Square(0, 0, 100);
  region.segments.push_back({2, 2});
  region.segments.push_back({1, 2});
  const auto result = TriangulateRegion(region.points, region.segments);
  ASSERT_THAT(Kinds(result), ::testing::ElementsAre(Kind::kDegenerate, Kind::kDegenerate));
  EXPECT_EQ(result.conflicts[0].first, 4);
  EXPECT_EQ(result.conflicts[1].first, 1);
  EXPECT_EQ(result.conflicts[1].second, 5);
}

TEST(RegionConflictTest, ClockwiseBoundaryIsInsideOut) {
  const RegionConflict conflict = FirstConflict(Region().Loop({{0, 0}, {0, 10}, {10, 0}}));
  EXPECT_EQ(conflict.kind, Kind::kInsideOut);
}

TEST(RegionConflictTest, OneReversedSegmentIsNamed) {
  Region region = Square(0, 0, 100);
  std::swap(region.segments[2].from, region.segments[2].to);
  const auto result = TriangulateRegion(region.points, region.segments);
  ASSERT_THAT(Kinds(result), ::testing::ElementsAre(Kind::kInsideOut));
  EXPECT_EQ(result.conflicts[0].first, 2);
}

TEST(RegionConflictTest, OpenChainIsInsideOut) {
  Region region = Square(0, 0, 100);
  region.segments.pop_back();
  EXPECT_EQ(FirstConflict(region).kind, Kind::kInsideOut);
}

TEST(RegionConflictTest, CounterClockwiseIslandIsInsideOut) {
  Region region = Square(0, 0, 100);
  region.Loop({{10, 10}, {20, 10}, {20, 20}});
  EXPECT_EQ(FirstConflict(region).kind, Kind::kInsideOut);
}

TEST(RegionConflictTest, CollinearInputs) {
  Region region;
  region.points = {{0, 0}, {10, 20}, {20, 40}, {5, 10}};
  region.LoopOf({0, 1});
  EXPECT_EQ(FirstConflict(region).kind, Kind::kInsideOut);
  region.LoopOf({0, 2});
  EXPECT_EQ(FirstConflict(region).kind, Kind::kPointOnSegment);
  EXPECT_EQ(FirstConflict(Region().Loop({{3, 3}, {3, 3}, {3, 3}})).kind, Kind::kCoincidentPoints);
  EXPECT_EQ(FirstConflict(Region().Loop({{3, 3}})).kind, Kind::kDegenerate);
}

TEST(RegionConflictTest, AtMostSixtyFourAreListed) {
  std::vector<LatticePoint> loop;
  for (int i = 0; i < 500; ++i) loop.push_back({i % 2 == 0 ? 0 : 1000, 3 * i});
  for (int i = 500; i > 0; --i) loop.push_back({i % 2 == 0 ? -7 : 1003, 3 * i + 1});
  EXPECT_EQ(TriangulateRegion(Region().Loop(loop).points, Region().Loop(loop).segments).conflicts.size(), 64u);
}

int Sign(testing::Int value) { return (value > 0) - (value < 0); }

bool IsInside(const Region& r, int32_t p, int32_t s) {  // the point lies in the open segment
  const LatticePoint a = r.points[r.segments[s].from], b = r.points[r.segments[s].to], c = r.points[p];
  return c != a && c != b && testing::Cross(a, b, c) == 0 && std::min(a, b) < c && c < std::max(a, b);
}

bool Cross(const Region& r, int32_t s, int32_t t) {  // the open segments meet in one point inside both
  const LatticePoint a = r.points[r.segments[s].from], b = r.points[r.segments[s].to];
  const LatticePoint c = r.points[r.segments[t].from], d = r.points[r.segments[t].to];
  return Sign(testing::Cross(a, b, c)) * Sign(testing::Cross(a, b, d)) < 0 &&
         Sign(testing::Cross(c, d, a)) * Sign(testing::Cross(c, d, b)) < 0;
}

// Asks all pairs whether what a conflict says is so. Inside-out is left to the area check of valid results.
bool IsTrue(const Region& r, const RegionConflict& c) {
  const auto& s = r.segments;
  switch (c.kind) {
    case Kind::kCoincidentPoints:
      return c.first < c.second && r.points[c.first] == r.points[c.second];
    case Kind::kCrossing:
      return Cross(r, c.first, c.second);
    case Kind::kPointOnSegment:
      return IsInside(r, c.second, c.first);
    case Kind::kDegenerate:
      return s[c.first].from == s[c.first].to ||
             (s[c.first].from == s[c.second].from && s[c.first].to == s[c.second].to);
    case Kind::kInsideOut:
      return true;
    case Kind::kCancelled:  // nobody cancels here
      return false;
  }
  return false;
}

bool HasGeometricConflict(const Region& r) {
  const auto count = static_cast<int32_t>(r.segments.size());
  for (int32_t s = 0; s < count; ++s) {
    if (r.points[r.segments[s].from] == r.points[r.segments[s].to]) return true;
    for (int32_t t = 0; t < count; ++t) {
      if (s == t) continue;
      if (Cross(r, s, t) || IsTrue(r, {Kind::kDegenerate, s, t})) return true;
      for (int32_t p : {r.segments[t].from, r.segments[t].to}) {
        if (IsInside(r, p, s)) return true;
        for (int32_t q : {r.segments[s].from, r.segments[s].to}) {
          if (p != q && r.points[p] == r.points[q]) return true;
        }
      }
    }
  }
  return false;
}

// Anything at all: never stops the program, and without conflicts the result is right.
TEST(TriangulateRegionTest, RandomRubbishIsReportedOrTriangulated) {
  std::mt19937 random(1);
  int valid = 0;
  for (int round = 0; round < 20'000; ++round) {
    SCOPED_TRACE(round);
    Region region;
    const int range = 2 + round % 9, points = 1 + round % 12, segments = round % 14;
    for (int i = 0; i < points; ++i) {
      const int64_t x = random() % range;
      region.points.push_back({x, static_cast<int64_t>(random() % range)});
    }
    for (int i = 0; i < segments; ++i) {
      const auto from = static_cast<int32_t>(random() % points);
      region.segments.push_back({from, static_cast<int32_t>(random() % points)});
      if (round % 2 == 0) region.segments.push_back({region.segments.back().to, from});
    }
    const auto result = TriangulateRegion(region.points, region.segments);
    const bool wrong = HasGeometricConflict(region);
    for (const RegionConflict& conflict : result.conflicts) {
      ASSERT_TRUE(IsTrue(region, conflict));
      ASSERT_EQ(conflict.kind != Kind::kInsideOut, wrong);
    }
    if (!result.conflicts.empty()) continue;
    ASSERT_FALSE(wrong);
    ++valid;
    CheckTopology(region.points, region.segments, result);
    if (!HasFatalFailure()) CheckDelaunay(region.points, result);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(valid, 10);
}

}  // namespace
}  // namespace tilemend
