#include "coordinator/plan/rim/border_audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// What tiles of float32 can say.
Point3 InFloats(const Point3& p) { return p.cast<float>().cast<double>(); }

// A tile of a 250 m cell grown by `margin` on every side, with its own vertices, as ContextCapture writes them.
SurveyedScene GrownTiles(double margin, bool floats = false) {
  std::map<CellId, TriMesh> tiles;
  for (int32_t col = 0; col < 2; ++col) {
    const int32_t squares = 25 + col;  // so that no vertices are shared
    const auto whole = [](int32_t, int32_t) { return true; };
    const double scale = (250 + 2 * margin) / squares;
    tiles[{col, 0}] = Moved(SquaresMesh(0, squares, 0, squares, whole), [&](const Point3& p) {
      const Point3 q = Point3(p * scale) + Point3(250 * col - margin, -margin, 0);
      return floats ? InFloats(q) : q;
    });
  }
  Grid grid;
  grid.cell_size = Point2(250, 250);
  return SurveyScene(grid, tiles);
}

TEST(AuditBordersTest, TellsTilesThatOverlap) {
  const SurveyedScene scene = GrownTiles(0.1);
  const BorderFindings found = AuditBorders(scene.Input());
  ASSERT_THAT(found.borders, SizeIs(1));
  EXPECT_EQ(found.borders[0].kind, BorderKind::kOverlap);
  EXPECT_NEAR(found.borders[0].offset, 0.2, 1e-9);
  EXPECT_NEAR(found.borders[0].margins[0], 0.1, 1e-9);
  EXPECT_NEAR(found.borders[0].margins[1], 0.1, 1e-9);
  EXPECT_GT(found.borders[0].apart.places, 40);
  EXPECT_TRUE(found.independent);
  EXPECT_NEAR(found.usual_offset, 0.1, 1e-9);
}

// Four tiles that overlap by 10 m; water lies along the first border, with shores in the strip of both.
TEST(AuditBordersTest, ShoresBetweenTilesThatEndStraightAreNoBuffers) {
  constexpr double kMargin = 5, kCell = 250;
  std::map<CellId, TriMesh> tiles;
  for (int32_t col = 0; col < 4; ++col) {
    const int32_t squares = 25 + col;
    const auto whole = [](int32_t, int32_t) { return true; };
    tiles[{col, 0}] = Moved(SquaresMesh(0, squares, 0, squares, whole), [&](const Point3& p) {
      const double scale = (kCell + 2 * kMargin) / squares, shore = 2 + std::sin(p.y());
      const double inward = col == 0 && p.x() == squares ? -shore : col == 1 && p.x() == 0 ? shore : 0;
      return Point3(p * scale + Point3(kCell * col - kMargin + inward, -kMargin, 0));
    });
  }
  Grid grid;
  grid.cell_size = Point2(kCell, kCell);
  const SurveyedScene scene = SurveyScene(grid, tiles);
  const BorderFindings found = AuditBorders(scene.Input());
  EXPECT_THAT(found.buffers, IsEmpty());
  EXPECT_FALSE(found.offsets.contains({CellId{0, 0}, kEast}));
  EXPECT_NEAR(found.usual_offset, kMargin, 1e-9);
}

TEST(AuditBordersTest, TellsTilesWithAGapBetween) {
  const SurveyedScene scene = GrownTiles(-0.1);
  const BorderFindings found = AuditBorders(scene.Input());
  ASSERT_THAT(found.borders, SizeIs(1));
  EXPECT_EQ(found.borders[0].kind, BorderKind::kGap);
  EXPECT_NEAR(found.borders[0].offset, -0.2, 1e-9);
  EXPECT_TRUE(found.independent);
}

TEST(AuditBordersTest, TellsTilesApartWhoseVerticesAreRounded) {
  for (const double margin : {0.1, -0.1}) {
    const SurveyedScene scene = GrownTiles(margin, true);
    const BorderFindings found = AuditBorders(scene.Input());
    ASSERT_THAT(found.borders, SizeIs(1));
    EXPECT_EQ(found.borders[0].kind, margin > 0 ? BorderKind::kOverlap : BorderKind::kGap);
    EXPECT_NEAR(found.borders[0].offset, 2 * margin, 1e-3);
    EXPECT_TRUE(found.independent);
  }
}

TEST(AuditBordersTest, CallsTilesNearThatEndAtTheLineAndShareNothing) {
  const SurveyedScene scene = GrownTiles(0);
  // The corners of the border are shared by two tiles that meet at the line; move them apart along it.
  std::map<CellId, TriMesh> tiles = scene.tiles;
  tiles[{1, 0}] = Moved(tiles[{1, 0}], [](const Point3& p) { return Point3(p + Point3(0, 0, 1)); });
  const SurveyedScene apart = SurveyScene(scene.grid, tiles);
  const BorderFindings found = AuditBorders(apart.Input());
  ASSERT_THAT(found.borders, SizeIs(1));
  EXPECT_EQ(found.borders[0].kind, BorderKind::kNear);
  EXPECT_EQ(found.borders[0].shared_vertices, 0);
  EXPECT_FALSE(found.independent);
  EXPECT_TRUE(found.clipped);
}

TEST(AuditBordersTest, CountsTheVerticesThatTilesShare) {
  const SurveyedScene scene = PictureScene({"##|##", "##|##", "--+--", "##|##", "##|##"}, 2);
  const BorderFindings found = AuditBorders(scene.Input());
  ASSERT_THAT(found.borders, SizeIs(4));
  for (const BorderAudit& border : found.borders) {
    EXPECT_EQ(border.kind, BorderKind::kExact);
    EXPECT_EQ(border.shared_vertices, 3);
    EXPECT_EQ(border.offset, 0);
    EXPECT_EQ(std::abs(border.b.col - border.a.col) + std::abs(border.b.row - border.a.row), 1);
    EXPECT_LT(border.a, border.b);
  }
}

TEST(AuditBordersTest, CallsABorderOpenWhereACellHasNoSurface) {
  const SurveyedScene scene = PictureScene({"##|..", "##|.."}, 2);
  const BorderFindings found = AuditBorders(scene.Input());
  ASSERT_THAT(found.borders, SizeIs(1));
  EXPECT_EQ(found.borders[0].kind, BorderKind::kOpen);
  EXPECT_FALSE(found.independent);
}

TEST(AuditBordersTest, TellsTheTwoCutsApart) {
  for (const Cut cut : {Cut::kClipped, Cut::kRagged}) {
    SceneMakerOptions options;
    options.cols = options.rows = 2;
    options.cut = cut;
    const SurveyedScene scene = SurveyScene(MakeScene(options));
    const BorderFindings found = AuditBorders(scene.Input());
    EXPECT_EQ(found.clipped, cut == Cut::kClipped);
    EXPECT_FALSE(found.independent);
  }
}

TEST(AuditBordersTest, MovesAlongWithTheGrid) {
  SurveyedScene scene = GrownTiles(0.125);
  const BorderFindings before = AuditBorders(scene.Input());
  scene.grid.corner += Point2(1000, -500);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) {
    tiles[cell] = Moved(tile, [](const Point3& p) { return Point3(p + Point3(1000, -500, 0)); });
  }
  const SurveyedScene moved = SurveyScene(scene.grid, tiles);
  const BorderFindings after = AuditBorders(moved.Input());
  EXPECT_EQ(after.borders[0].kind, before.borders[0].kind);
  EXPECT_NEAR(after.borders[0].offset, before.borders[0].offset, 1e-9);
  EXPECT_EQ(after.offsets.size(), before.offsets.size());
}

TEST(AuditBordersTest, FindsNothingWithoutAGrid) {
  const SurveyedScene scene = GrownTiles(0.1);
  PlanInput input = scene.Input();
  input.has_grid = false;
  const BorderFindings found = AuditBorders(input);
  EXPECT_THAT(found.borders, IsEmpty());
  EXPECT_THAT(found.offsets, IsEmpty());
  EXPECT_FALSE(found.independent);
}

}  // namespace
}  // namespace tilemend
