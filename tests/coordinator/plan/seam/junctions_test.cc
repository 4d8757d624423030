#include "coordinator/plan/seam/junctions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/rim_builders.h"
#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

constexpr Border kMiddle{{0, 0}, {1, 0}};

size_t Count(const Junctions& junctions) {
  size_t count = 0;
  for (const auto& [border, of_border] : junctions.along) count += of_border.size();
  return count;
}

TEST(FindJunctionsTest, FindsWhereALineEntersAndLeavesAHole) {
  const SeamScene s({"####|####", "##..|.###", "##..|.###", "####|####"}, 4);
  const Junctions junctions = FindJunctions(s.Site(), s.closing);
  const std::vector<Junction>& middle = junctions.along.at(kMiddle);
  ASSERT_EQ(middle.size(), 2U);
  EXPECT_EQ(middle[0].t, 1);
  EXPECT_TRUE(middle[0].start);
  EXPECT_EQ(s.rim.points[middle[0].point].position, Point3(4, 1, 0));
  EXPECT_EQ(middle[1].t, 3);
  EXPECT_FALSE(middle[1].start);
  EXPECT_EQ(Count(junctions), 2U);
  EXPECT_TRUE(junctions.failures.empty());
}

TEST(FindJunctionsTest, TellsOfBordersThatTheRimCrossesAlone) {
  const SeamScene s({"##|##", "##|##"}, 2);
  EXPECT_TRUE(FindJunctions(s.Site(), s.closing).along.empty());
}

TEST(FindJunctionsTest, FindsTheSameOnALineTheOtherWayRound) {
  const SeamScene s({"####", "#..#", "#..#", "#..#", "----", "#..#", "#..#", "####", "####"}, 4);
  const std::vector<Junction> along = FindJunctions(s.Site(), s.closing).along.at({{0, 0}, {0, 1}});
  ASSERT_EQ(along.size(), 2U);
  EXPECT_EQ(along[0].t, 1);
  EXPECT_TRUE(along[0].start);
  EXPECT_EQ(along[1].t, 3);
  EXPECT_FALSE(along[1].start);
}

TEST(FindJunctionsTest, MakesStartsAndEndsTakeTurns) {
  const SeamScene s(
      {"######|######", "##....|....##", "######|######", "###...|..####", "######|######", "######|######"}, 6);
  const Junctions junctions = FindJunctions(s.Site(), s.closing);
  EXPECT_EQ(junctions.along.at(kMiddle).size(), 4U);
  for (const auto& [border, of_border] : junctions.along) {
    for (size_t i = 1; i < of_border.size(); ++i) EXPECT_NE(of_border[i - 1].start, of_border[i].start);
  }
}

// The first two at one place, the low corner in no surface; but one more begins than ends.
TEST(FindJunctionsTest, BeginsAsAllOfThemTellWhereTheFirstDoNot) {
  const SeamScene s({"####|####", "####|####", "####|####", "####|####"}, 4);
  const std::set<CellId> area = AreaOf(3, 3);
  const GridLines lines = LinesOf(area, 4);
  const Rim rim = RimOf({{{3, .5, 0}, {6, .5, 0}, {6, 5, 0}, {4, 3, 0}, {5, 1, 0}, {4, 1, 0}}});
  const RimIndex index(rim);
  const SeamSite site{area, lines, rim, index, s.options, 0x1p-10};
  const Junctions junctions = FindJunctions(site, {{0, 1}, {1, 1}, {1, 0}, {0, 0}, {1, 0}, {0, 0}});
  const std::vector<Junction>& middle = junctions.along.at(kMiddle);
  ASSERT_EQ(middle.size(), 3U);
  EXPECT_EQ(middle[1].t, 1);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(middle[i].start, i != 1);
}

// A loop whose edges cells at corners from each other close on, and cells that are no neighbours.
TEST(FindJunctionsTest, GoesAcrossACornerByTheCellOnTheHolesSide) {
  const SeamScene s({"####|####", "####|####", "####|####", "####|####"}, 4);
  const std::set<CellId> area = AreaOf(3, 3);
  const GridLines lines = LinesOf(area, 4);
  const Rim rim = RimOf({{{5, 5, 0}, {4, 7, 0}, {6, 6, 0}}});
  const RimIndex index(rim);
  const SeamSite site{area, lines, rim, index, s.options, 0x1p-10};
  const Junctions corner = FindJunctions(site, {{0, 0}, {1, 1}, {1, 1}});
  EXPECT_EQ(corner.along.at({{0, 0}, {1, 0}}).size(), 1U) << "from (0, 0) north-east, the hole to the right";
  EXPECT_EQ(corner.along.at({{1, 0}, {1, 1}}).size(), 1U);
  EXPECT_EQ(corner.along.at({{0, 0}, {0, 1}}).size(), 1U) << "and back";
  EXPECT_TRUE(corner.failures.empty());
  const Junctions far = FindJunctions(site, {{0, 0}, {2, 2}, {2, 2}});
  EXPECT_EQ(Count(far), 0U);
  EXPECT_EQ(far.failures.size(), 2U);
}

// A hole over a grid corner, the only one of nine that lies in a hole.
const std::vector<std::string> kHoleOverACorner = {"####|####", "####|####", "##..|.###", "##..|.###", "----+----",
                                                   "##..|.###", "####|####", "####|####", "####|####"};

TEST(FindCornersInHolesTest, TellsCornersInHolesFromThoseOnTheSurface) {
  const SeamScene s(kHoleOverACorner, 4);
  const auto in_hole = FindCornersInHoles(s.Site(), s.closing, FindJunctions(s.Site(), s.closing));
  EXPECT_EQ(in_hole, std::set<Corner>({{1, 1}}));
}

TEST(FindCornersInHolesTest, AsksTheWindingNumberWithoutJunctions) {
  const SeamScene s(kHoleOverACorner, 4);
  const auto in_hole = FindCornersInHoles(s.Site(), s.closing, Junctions());
  EXPECT_EQ(in_hole, std::set<Corner>({{1, 1}}));
}

// The corner at (4, 4) lies beyond the surface, which ends in a zigzag a little short of it.
TEST(FindCornersInHolesTest, TakesACornerThatTheOutlinePassesByForNoHole) {
  const std::set<CellId> area = AreaOf(1, 1);
  GridLines lines = LinesOf(area, 4);
  lines.clipped = false;
  const Rim rim = RimOf({{{0, 0, 0}, {4, 0, 0}, {3.8, 1.5, 0}, {3.7, 3.7, 0}, {1.5, 3.8, 0}, {0, 4, 0}}});
  const RimIndex index(rim);
  const PlanOptions options;
  const SeamSite site{area, lines, rim, index, options, 0x1p-10};
  const ClosingCells outline(rim.edges.size(), CellId{1, 1}), rim_of_hole(rim.edges.size(), CellId{0, 0});
  const Corner corner{1, 1};
  const auto in_hole = [&](const ClosingCells& closing) {
    return FindCornersInHoles(site, closing, Junctions()).contains(corner);
  };
  EXPECT_TRUE(in_hole(outline)) << "without a zigzag";
  lines.zigzag = {{{0, 0}, kEast}, {{0, 0}, kNorth}};
  EXPECT_FALSE(in_hole(outline));
  EXPECT_TRUE(in_hole(rim_of_hole));
}

}  // namespace
}  // namespace tilemend
