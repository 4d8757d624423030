#include "coordinator/plan/rim/grid_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

constexpr double kStep = 0x1p-10;

GridLines FindLines(const PlanInput& input) { return FindGridLines(input, AuditBorders(input), kStep); }

// Two whole cells of 4 m, with the vertices that fulfil `moves` at `move`'s place.
template <typename Move>
SurveyedScene TwoCells(const Move& move) {
  const SurveyedScene scene = PictureScene({"####|####", "####|####", "####|####", "####|####"}, 4);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) tiles[cell] = Moved(tile, move);
  return SurveyScene(scene.grid, tiles);
}

TEST(FindGridLinesTest, TakesTheGridsLinesWhereTilesEndAtThem) {
  const SurveyedScene scene = TwoCells([](const Point3& p) { return p; });
  const GridLines lines = FindLines(scene.Input());
  EXPECT_TRUE(lines.clipped);
  for (const int32_t col : {0, 1}) {
    EXPECT_EQ(lines.At({col, 0}, kWest), 4 * col);
    EXPECT_EQ(lines.At({col, 0}, kEast), 4 * col + 4);
    EXPECT_EQ(lines.At({col, 0}, kSouth), 0);
    EXPECT_EQ(lines.At({col, 0}, kNorth), 4);
  }
}

TEST(FindGridLinesTest, TakesTheCoordinateThatMostOfTheBoundaryRunsAlong) {
  const double line = 4.0003;
  const SurveyedScene scene = TwoCells([&](const Point3& p) { return Point3(p.x() == 4 ? line : p.x(), p.y(), 0); });
  const GridLines lines = FindLines(scene.Input());
  EXPECT_EQ(lines.At({0, 0}, kEast), line);
  EXPECT_EQ(lines.At({1, 0}, kWest), line);
  EXPECT_EQ(lines.At({0, 0}, kWest), 0);
}

TEST(FindGridLinesTest, NeedsNoToleranceWhereTheBoundaryLiesOnTheLinesToTheBit) {
  const SurveyedScene exact = TwoCells([](const Point3& p) { return p; });
  EXPECT_EQ(FindLines(exact.Input()).tolerance, 0);
  const SurveyedScene rough = TwoCells(
      [](const Point3& p) { return Point3(p + Point3(2e-4 * std::sin(7 * p.y()), 2e-4 * std::sin(9 * p.x()), 0)); });
  EXPECT_EQ(FindLines(rough.Input()).tolerance, kOnLine);
}

TEST(FindGridLinesTest, RoundsLinesThatNothingEndsAtToTheLattice) {
  SurveyedScene scene = PictureScene({"..|..", "..|.."}, 2);
  scene.grid.corner = Point2(0.3, 0);
  const GridLines lines = FindLines(scene.Input());
  EXPECT_NEAR(lines.At({0, 0}, kWest), 0.3, kStep);
  EXPECT_EQ(std::fmod(lines.At({0, 0}, kWest), kStep), 0);
}

TEST(FindGridLinesTest, FollowsTheOutlinesOfIndependentTiles) {
  std::map<CellId, TriMesh> tiles;
  const auto whole = [](int32_t, int32_t) { return true; };
  for (const int32_t col : {0, 1}) {
    const int32_t squares = 25 + col;
    tiles[{col, 0}] = Moved(SquaresMesh(0, squares, 0, squares, whole), [&](const Point3& p) {
      return Point3(p * (100.5 / squares) + Point3(100 * col - 0.25, -0.25, 0));
    });
  }
  Grid grid;
  grid.cell_size = Point2(100, 100);
  const SurveyedScene scene = SurveyScene(grid, tiles);
  const GridLines lines = FindLines(scene.Input());
  EXPECT_NEAR(lines.At({0, 0}, kEast), 100.25, 1e-9);
  EXPECT_NEAR(lines.At({1, 0}, kWest), 99.75, 1e-9);
  EXPECT_NEAR(lines.pieces.reach, 0.75, 1e-9);
}

TEST(FindGridLinesTest, LeavesTheRimOfAnUnknownAreaOpen) {
  SurveyedScene scene = TwoCells([](const Point3& p) { return p; });
  EXPECT_TRUE(FindLines(scene.Input()).left_open.empty());
  scene.area_known = false;
  const auto open = FindLines(scene.Input()).left_open;
  EXPECT_EQ(open.size(), 6U);
  EXPECT_FALSE(open.contains({{0, 0}, {1, 0}}));
  EXPECT_TRUE(open.contains({{-1, 0}, {0, 0}}));
  EXPECT_TRUE(open.contains({{1, 0}, {1, 1}}));
}

// A scene of 2 x 2 cells without the north-eastern one.
GridLines LinesOfThreeCells(Cut cut) {
  SceneMakerOptions options;
  options.cols = options.rows = 2;
  options.cut = cut;
  options.out_of_area = {{1, 1}};
  return FindLines(SurveyScene(MakeScene(options)).Input());
}

TEST(FindGridLinesTest, FindsTheZigzagThatARaggedCutEndsIn) {
  const std::set<std::pair<CellId, int>> inner = {{{0, 1}, kEast}, {{1, 0}, kNorth}};
  EXPECT_EQ(LinesOfThreeCells(Cut::kRagged).zigzag, inner) << "the outer rim of the made scene is straight";
  EXPECT_TRUE(LinesOfThreeCells(Cut::kClipped).zigzag.empty());
}

TEST(FindGridLinesTest, HasLinesThatNothingLiesOnWithoutAGrid) {
  const SurveyedScene scene = TwoCells([](const Point3& p) { return p; });
  PlanInput input = scene.Input();
  input.has_grid = false;
  const GridLines lines = FindLines(input);
  EXPECT_LT(lines.tolerance, 0);
  EXPECT_TRUE(lines.left_open.contains({{0, 0}, {1, 0}}));
}

TEST(GridLinesTest, CountsDistancesInwardFromEverySide) {
  const SurveyedScene scene = TwoCells([](const Point3& p) { return p; });
  const GridLines lines = FindLines(scene.Input());
  const Point3 p(1, 3.5, 0);
  EXPECT_EQ(lines.Inside(p, {0, 0}, kWest), 1);
  EXPECT_EQ(lines.Inside(p, {0, 0}, kEast), 3);
  EXPECT_EQ(lines.Inside(p, {0, 0}, kSouth), 3.5);
  EXPECT_EQ(lines.Inside(p, {0, 0}, kNorth), 0.5);
  EXPECT_EQ(lines.Inside(p, {1, 0}, kWest), -3);
}

}  // namespace
}  // namespace tilemend
