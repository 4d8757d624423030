#include "worker/fill/region/planar_region.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace tilemend {
namespace {

// The rim of a square of 8 metres, a vertex a metre.
std::vector<Point2> Rim() {
  std::vector<Point2> rim;
  for (int k = 0; k < 8; ++k) rim.emplace_back(k, 0);
  for (int k = 0; k < 8; ++k) rim.emplace_back(8, k);
  for (int k = 0; k < 8; ++k) rim.emplace_back(8 - k, 8);
  for (int k = 0; k < 8; ++k) rim.emplace_back(0, 8 - k);
  return rim;
}

std::vector<RegionSegment> Segments() {
  std::vector<RegionSegment> segments;
  for (int32_t k = 0; k < 32; ++k) segments.push_back({k, (k + 1) % 32});
  return segments;
}

const std::vector<RegionSegment> kSquare = Segments();

struct Square {
  PlanarPoints planar = RoundToWindow(Rim(), std::vector<double>(32, 1));
  RefinedRegion region = RefineRegion(planar.points, kSquare, planar.sizes, {.uniform = true});

  // Twice the area; every triangle counts up.
  int64_t TwiceArea() const {
    const auto at = [&](int32_t v) { return v < 32 ? planar.points[v] : region.new_points[v - 32]; };
    int64_t sum = 0;
    for (const Triangle& t : region.triangulation.triangles) {
      const LatticePoint a = at(t[0]), b = at(t[1]), c = at(t[2]);
      const int64_t area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      EXPECT_GT(area, 0);
      sum += area;
    }
    return sum;
  }
};

TEST(PlanarRegionTest, RoundsToTheWindowsLattice) {
  const Square square;
  for (size_t i = 0; i < 32; ++i) EXPECT_DOUBLE_EQ(square.planar.sizes[i] * square.planar.window.step(), 1);
  EXPECT_EQ(square.planar.window.ToMetres(square.planar.points[16]), Point2(8, 8));
}

TEST(PlanarRegionTest, KeepsTheRegionWithoutSomeOfItsPoints) {
  Square square;
  const size_t count = square.region.new_points.size();
  ASSERT_GT(count, 10u);
  const int64_t area = square.TwiceArea();
  std::vector<bool> kept(count, true);
  for (size_t k = 0; k < count; k += 3) kept[k] = false;
  const std::vector<LatticePoint> before = square.region.new_points;
  KeepNewPoints(kept, square.planar.points, kSquare, square.region);
  EXPECT_EQ(square.region.new_points.size(), count - (count + 2) / 3);
  EXPECT_EQ(square.TwiceArea(), area);
  std::set<LatticePoint> wanted;
  for (size_t k = 0; k < count; ++k) {
    if (kept[k]) wanted.insert(before[k]);
  }
  EXPECT_EQ(std::set<LatticePoint>(square.region.new_points.begin(), square.region.new_points.end()), wanted);
}

TEST(PlanarRegionTest, LeavesOutAPointOnASegment) {
  Square square;
  const size_t count = square.region.new_points.size();
  const LatticePoint a = square.planar.points[0], b = square.planar.points[1];
  square.region.new_points.push_back({(a.x + b.x) / 2, a.y});
  KeepNewPoints(std::vector<bool>(count + 1, true), square.planar.points, kSquare, square.region);
  EXPECT_EQ(square.region.new_points.size(), count);
}

TEST(PlanarRegionTest, MovesPointsToACoarseLattice) {
  Square square;
  const int64_t area = square.TwiceArea();
  const auto coarse = [](const Point2& p) {
    const Point2 q = (p * 8).array().round() / 8;
    return std::array<Point2, 2>{q, q};
  };
  MoveNewPoints(square.planar.window, coarse, square.planar.points, kSquare, square.region);
  EXPECT_EQ(square.TwiceArea(), area);
  ASSERT_FALSE(square.region.new_points.empty());
  for (const LatticePoint& p : square.region.new_points) {
    const Point2 at = square.planar.window.ToMetres(p) * 8;
    EXPECT_EQ(at, Point2(at.array().round()));
  }
}

TEST(PlanarRegionTest, TakesTheSecondPlaceWhereTheFirstIsOffTheWindowsLattice) {
  Square square;
  const std::vector<LatticePoint> before = square.region.new_points;
  const double off = square.planar.window.step() / 3;
  MoveNewPoints(
      square.planar.window,
      [&](const Point2& p) {
        return std::array<Point2, 2>{p + Point2(off, 0), p};
      },
      square.planar.points, kSquare, square.region);
  EXPECT_EQ(square.region.new_points, before);
}

TEST(PlanarRegionTest, LeavesOutPointsThatCanGoNowhere) {
  Square square;
  MoveNewPoints(
      square.planar.window,
      [](const Point2&) {
        return std::array<Point2, 2>{Point2(-0.25, -0.25), Point2(-0.25, 0)};
      },
      square.planar.points, kSquare, square.region);
  EXPECT_TRUE(square.region.new_points.empty());
  EXPECT_EQ(square.region.triangulation.triangles.size(), 30u);
}

}  // namespace
}  // namespace tilemend
