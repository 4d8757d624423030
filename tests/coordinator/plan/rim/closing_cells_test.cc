#include "coordinator/plan/rim/closing_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/rim_builders.h"
#include "tests/support/seam_scene.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using Picture = std::vector<std::string>;

// Where there is no surface on an edge's right-hand side, 0.4 m beside its middle.
CellId CellBeside(const SeamScene& c, const RimEdge& e) {
  const Point2 a = c.rim.points[e.from].position.head<2>(), b = c.rim.points[e.to].position.head<2>();
  const Point2 d = (b - a).normalized(), beside = (a + b) / 2 + 0.4 * Point2(d.y(), -d.x());
  const Point2 at = (beside - c.input.grid.corner).cwiseQuotient(c.input.grid.cell_size);
  return {static_cast<int32_t>(std::floor(at.x())), static_cast<int32_t>(std::floor(at.y()))};
}

void ExpectTheCellsThatTheHolesLieIn(const SeamScene& c) {
  ASSERT_FALSE(c.rim.edges.empty());
  for (size_t i = 0; i < c.rim.edges.size(); ++i) {
    const RimEdge& e = c.rim.edges[i];
    EXPECT_EQ(c.closing[i], CellBeside(c, e))
        << c.rim.points[e.from].position.transpose() << " -> " << c.rim.points[e.to].position.transpose();
  }
}

TEST(FindClosingCellsTest, GivesEdgesOfAClippedCutToTheCellThatTheHoleLiesIn) {
  const std::vector<Picture> pictures = {{"####|####", "##..|.###", "##..|.###", "####|####"},
                                         {"####|####", "####|####", "####|....", "####|####", "----+----", "####|####",
                                          "#...|####", "#...|####", "####|####"},
                                         {"####|....|####", "####|....|####", "####|....|####", "####|....|####"},
                                         {"....|####", "....|#..#", "....|#..#", "....|####"}};
  for (const Picture& picture : pictures) ExpectTheCellsThatTheHolesLieIn(SeamScene(PictureScene(picture, 4)));
}

TEST(FindClosingCellsTest, DoesNotDependOnWhereTheSceneLies) {
  SurveyedScene scene = PictureScene({"####|####", "##..|.###", "##..|....", "####|####"}, 4);
  const Point3 move(-4000, 800, 50);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) {
    tiles[cell] = Moved(tile, [&](const Point3& p) { return Point3(p + move); });
  }
  Grid grid = scene.grid;
  grid.corner += move.head<2>();
  const SeamScene here(scene), there(SurveyScene(grid, tiles));
  EXPECT_EQ(here.closing, there.closing);
}

// The border vertices of the eastern tile lie halfway between those of the western one.
TEST(FindClosingCellsTest, GivesAHairlineBetweenTilesToTheLowerCell) {
  const SurveyedScene scene = PictureScene({"####|####", "####|####", "####|####", "####|####"}, 4);
  std::map<CellId, TriMesh> tiles = scene.tiles;
  tiles[{1, 0}] = Moved(tiles[{1, 0}], [](const Point3& p) {
    const bool inner = p.x() == 4 && p.y() > 0 && p.y() < 4;
    return Point3(p.x() + (inner ? 2e-4 : 0), p.y() + (inner ? 0.5 : 0), 0);
  });
  const SeamScene c(SurveyScene(scene.grid, tiles));
  ASSERT_GT(c.lines.tolerance, 0);
  int western = 0, eastern = 0;
  for (size_t i = 0; i < c.rim.edges.size(); ++i) {
    const RimEdge& e = c.rim.edges[i];
    const double x = (c.rim.points[e.from].position.x() + c.rim.points[e.to].position.x()) / 2;
    if (std::abs(x - 4) > 0.01) continue;
    ++(e.owner == CellId{0, 0} ? western : eastern);
    EXPECT_EQ(c.closing[i], (CellId{0, 0}));
  }
  EXPECT_EQ(western, 4);
  EXPECT_EQ(eastern, 4);
}

// Edges of the western tile along the line x = 10, `off` metres inside, at the side of a hole in the eastern cell.
ClosingCells ClosingOnRaggedCut(double off, const std::set<CellId>& area = AreaOf(2, 1), bool zigzag = false) {
  GridLines lines = LinesOf(area, 10);
  lines.clipped = false;
  if (zigzag) lines.zigzag = {{{0, 0}, kEast}};
  Rim rim = RimOf({{{10 - off, 2, 0},
                    {10 - off, 3, 0},
                    {10 - off, 4, 0},
                    {10 - off, 5, 0},
                    {18, 5, 0},
                    {18, 4, 0},
                    {18, 3, 0},
                    {18, 2, 0}}});
  for (size_t e = 3; e < rim.edges.size() && area.contains({1, 0}); ++e) rim.edges[e].owner = {1, 0};
  return FindClosingCells(CellsOf(area, 10), lines, rim);
}

TEST(FindClosingCellsTest, GivesEdgesOfARaggedCutAcrossWithinAnEdgesLengthOfTheLine) {
  const CellId east{1, 0};
  EXPECT_EQ(ClosingOnRaggedCut(0.8)[1], east);
  EXPECT_EQ(ClosingOnRaggedCut(-0.8)[1], east);
  EXPECT_EQ(ClosingOnRaggedCut(2.5)[1], (CellId{0, 0}));
}

TEST(FindClosingCellsTest, GivesEdgesOutOfTheAreaInAZigzagAlone) {
  const CellId own{0, 0}, outside{1, 0};
  EXPECT_EQ(ClosingOnRaggedCut(0.8, {own}, true)[1], outside);
  EXPECT_EQ(ClosingOnRaggedCut(-0.8, {own}, true)[1], outside);
  EXPECT_EQ(ClosingOnRaggedCut(2.5, {own}, true)[1], own);
  EXPECT_EQ(ClosingOnRaggedCut(0.8, {own}, false)[1], own) << "the area ends in a straight line: here is a hole";
}

TEST(GiveBackNearTest, GivesEdgesBackWithinReachAlone) {
  const SeamScene c(PictureScene({"####|####|....", "####|####|....", "####|####|....", "####|####|...."}, 4));
  const std::vector<Point2> trouble = {{8, 0}};
  ClosingCells given = c.closing;
  GiveBackNear(c.input, c.rim, trouble, 2.5, given);
  int near = 0, far = 0;
  for (size_t i = 0; i < c.rim.edges.size(); ++i) {
    const RimEdge& e = c.rim.edges[i];
    if (c.closing[i] != CellId{2, 0}) continue;
    const bool in_reach = (c.rim.points[e.from].position.head<2>() - trouble[0]).norm() <= 2.5;
    ++(in_reach ? near : far);
    EXPECT_EQ(given[i], in_reach ? e.owner : (CellId{2, 0}));
  }
  EXPECT_GT(near, 0);
  EXPECT_GT(far, 0);
}

TEST(GiveBackNearTest, LeavesEdgesThatFaceOutOfTheArea) {
  const SeamScene c(PictureScene({"####", "####", "####", "####"}, 4));
  ClosingCells given = c.closing;
  GiveBackNear(c.input, c.rim, std::vector<Point2>{{2, 2}}, 100, given);
  EXPECT_EQ(given, c.closing);
  EXPECT_TRUE(std::none_of(given.begin(), given.end(), [](CellId cell) { return cell == CellId{0, 0}; }));
}

}  // namespace
}  // namespace tilemend
