#include "coordinator/plan/overlap/area_outside.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/mesh/rounding.h"
#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using Ring = std::vector<Point2>;

constexpr std::array<double, 4> kBox = {0, 10, 0, 10};
constexpr double kStep = 0x1p-10;

// As rims have it, the inside on the right.
Ring Clockwise(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }

double AreaOf(const AreaOutside& outside) {
  double area = 0;
  for (const DirectedEdge& e : outside.edges) {
    const Point2 &a = outside.points[e.from], &b = outside.points[e.to];
    area += (a.x() * b.y() - b.x() * a.y()) / 2;
  }
  return area;
}

TEST(OutsideInTest, IsNothingWhereTheAreaHoldsTheBox) {
  EXPECT_THAT(OutsideIn({Clockwise(-1, -1, 11, 11)}, kBox, kStep).edges, IsEmpty());
  EXPECT_THAT(OutsideIn({Clockwise(0, 0, 10, 10)}, kBox, kStep).edges, IsEmpty());
}

TEST(OutsideInTest, IsTheBoxWhereTheAreaIsElsewhere) {
  EXPECT_EQ(AreaOf(OutsideIn({Clockwise(20, 0, 30, 10)}, kBox, kStep)), 100);
}

TEST(OutsideInTest, WindsAroundWhatIsOutside) {
  const AreaOutside outside = OutsideIn({Clockwise(-5, -5, 4.5, 20)}, kBox, kStep);
  EXPECT_EQ(AreaOf(outside), 55);
  EXPECT_TRUE(outside.Contains({5, 5}));
  EXPECT_FALSE(outside.Contains({4, 5}));
}

TEST(OutsideInTest, HolesOfAnAreaAreOutside) {
  Ring hole = Clockwise(4, 4, 6, 6);
  std::reverse(hole.begin(), hole.end());
  const AreaOutside outside = OutsideIn({Clockwise(1, 1, 9, 9), hole}, kBox, kStep);
  EXPECT_EQ(AreaOf(outside), 100 - 64 + 4);
  EXPECT_TRUE(outside.Contains({5, 5}));
  EXPECT_FALSE(outside.Contains({3, 5}));
}

TEST(OutsideInTest, NewPointsLieOnTheBoxAndOnTheLattice) {
  const AreaOutside outside = OutsideIn({{{3, -5}, {-2, 15}, {7, 15}}}, kBox, kStep);
  for (const Point2& p : outside.points) {
    EXPECT_TRUE(p.x() == 0 || p.x() == 10 || p.y() == 0 || p.y() == 10) << p.transpose();
    EXPECT_EQ(p.x() / kStep, std::round(p.x() / kStep));
    EXPECT_EQ(p.y() / kStep, std::round(p.y() / kStep));
  }
}

TEST(SpacedRingsTest, FollowTheAreaRoundOnce) {
  SeamScene s({"####", "#..#", "#..#", "####"}, 4);
  s.input.area.rings = {{{0.5, 0.5}, {3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}};
  const std::vector<Ring> rings = SpacedRings(s.Site(), s.input);
  ASSERT_THAT(rings, SizeIs(1));
  EXPECT_EQ(AreaOf(OutsideIn(rings, {0, 4, 0, 4}, kStep)), 16 - 9);
}

TEST(SpacedRingsTest, KeepOffLinesBetweenCells) {
  SeamScene s({"########", "#......#", "#......#", "########"}, 4);
  s.input.area.rings = {{{4, 0}, {8, 0}, {8, 4}, {4, 4}}};
  const std::vector<Ring> rings = SpacedRings(s.Site(), s.input);
  ASSERT_THAT(rings, SizeIs(1));
  const auto x = [](const Point2& p) { return p.x(); };
  EXPECT_DOUBLE_EQ(std::ranges::min(rings[0], {}, x).x(), RoundedToLattice(4.002, kStep));
  EXPECT_EQ(std::ranges::max(rings[0], {}, x).x(), 8);
}

TEST(SpacedRingsTest, KeepCornersOffLinesThatTheyTouch) {
  SeamScene s({"########", "#......#", "#......#", "########"}, 4);
  s.input.area.rings = {{{4, 2}, {7, 1}, {7, 3}}};
  const std::vector<Ring> touching = SpacedRings(s.Site(), s.input);
  const auto x = [](const Point2& p) { return p.x(); };
  EXPECT_DOUBLE_EQ(std::ranges::min(touching[0], {}, x).x(), RoundedToLattice(4.002, kStep));
  s.input.area.rings = {{{4, 1}, {7, 2}, {4, 3}, {1, 2}}};
  const std::vector<Ring> passing = SpacedRings(s.Site(), s.input);
  EXPECT_EQ(std::ranges::count(passing[0], 4, x), 2) << "corners where the ring passes the line";
}

// Both go off the lines there, across each other.
TEST(SpacedRingsTest, RingsThatMeetAtACornerOfTheGridBecomeOne) {
  SeamScene s({"################", "#..............#", "#..............#", "################", "################",
               "#..............#", "#..............#", "################"},
              4);
  s.input.area.rings = {{{0.5, 0.5}, {15.5, 0.5}, {15.5, 7.5}, {0.5, 7.5}},
                        {{2, 2}, {4, 2}, {4, 4}, {2, 4}},
                        {{4, 4}, {6, 4}, {6, 6}, {4, 6}}};
  const std::vector<Ring> rings = SpacedRings(s.Site(), s.input);
  ASSERT_THAT(rings, SizeIs(2));
  EXPECT_NEAR(AreaOf(OutsideIn(rings, {0, 16, 0, 8}, kStep)), 16 * 8 - 15 * 7 + 2 * 4, 0.05);
}

}  // namespace
}  // namespace tilemend
