#include "coordinator/plan/hole/free_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "coordinator/plan/plan.h"

namespace tilemend {
namespace {

constexpr CellId kCell{0, 0};

// A tile of 20 m with a hole of 16 m, and squares of surface over it or over the tile.
struct PieceScene {
  PieceScene() {
    AddSquare(0, 20, 0, true);
    AddSquare(2, 18, 0, false);
    record.lo = Point3(0, 0, 0);
    record.hi = Point3(20, 20, 100);
    record.vertex_count = 1;
    record.triangle_count = 1;
  }

  // From (lo, lo) to (hi, hi); a piece of its own, or a hole in the last one.
  void AddSquare(double lo, double hi, double z, bool is_piece) {
    const auto first = static_cast<int32_t>(record.vertices.size());
    if (is_piece) ++pieces;
    for (const auto& [x, y] : {std::pair(lo, lo), {hi, lo}, {hi, hi}, {lo, hi}}) {
      const int32_t index = static_cast<int32_t>(record.vertices.size());
      record.vertices.push_back({index, Point3(x, y, z), Eigen::Vector3d(0, 0, 1), z});
      ground.on_object.push_back(z > 0);
      ground.ground.push_back(0);
    }
    for (int32_t k = 0; k < 4; ++k) {
      const int32_t a = first + k, b = first + (k + 1) % 4;
      record.edges.push_back({is_piece ? a : b, is_piece ? b : a, pieces - 1});
    }
  }

  PlanInput Input() const {
    PlanInput input;
    input.grid = {Point2(0, 0), Point2(20, 20)};
    input.cells[kCell] = StoredRecord(&record);
    input.rim_ground[kCell] = ground;
    return input;
  }

  SurveyRecord record;
  RimGround ground;
  int32_t pieces = 0;
};

TEST(FindFreePiecesTest, TakesWhatAWallOfOverTenTimesItsAreaWouldHold) {
  for (const double z : {0.5, 2.4, 2.6, 20.0}) {
    PieceScene scene;
    scene.AddSquare(8, 9, z, true);
    const FreePieces found = FindFreePieces(scene.Input());
    EXPECT_EQ(found, z > 2.5 ? FreePieces({{kCell, {1}}}) : FreePieces()) << z;
  }
}

TEST(FindFreePiecesTest, NotOverOtherSurfaceNorAtTheOutlineOfTheTile) {
  for (const double lo : {0.4, 0.0, 1.9}) {
    PieceScene scene;
    scene.AddSquare(lo, lo + 1, 20, true);
    EXPECT_TRUE(FindFreePieces(scene.Input()).empty()) << lo;
  }
}

TEST(FindFreePiecesTest, NotWhereAVertexStandsOnTheGroundOrThatIsNotKnown) {
  PieceScene scene;
  scene.AddSquare(8, 9, 20, true);
  scene.ground.on_object.back() = false;
  EXPECT_TRUE(FindFreePieces(scene.Input()).empty());
  scene.ground.on_object.back() = true;
  scene.ground.ground.back() = NAN;
  EXPECT_TRUE(FindFreePieces(scene.Input()).empty());
  PlanInput input = scene.Input();
  input.rim_ground.clear();
  EXPECT_TRUE(FindFreePieces(input).empty());
}

TEST(WithoutPiecesTest, LeavesTheOtherEdgesAndAllVertices) {
  PieceScene scene;
  scene.AddSquare(8, 9, 20, true);
  scene.AddSquare(11, 12, 20, true);
  const PlanInput without = WithoutPieces(scene.Input(), {{kCell, {1}}});
  const StoredRecord::Pointer record = without.cells.at(kCell).Outline();
  EXPECT_EQ(record->vertices.size(), 16U);
  ASSERT_EQ(record->edges.size(), 12U);
  for (const BoundaryEdge& e : record->edges) EXPECT_NE(e.piece, 1);
}

// A plate stays open, as its outline is no hole; a hole in it is one.
TEST(FreePiecesTest, TheHoleGoesOnBelowThem) {
  PieceScene scene;
  scene.AddSquare(8, 9, 20, true);
  PieceScene with_hole;
  with_hole.AddSquare(8, 9, 20, true);
  with_hole.AddSquare(8.4, 8.6, 20, false);
  for (const PieceScene* s : {&scene, &with_hole}) {
    const Plan plan = MakePlan(s->Input(), {});
    ASSERT_FALSE(plan.holes.empty());
    EXPECT_EQ(plan.holes[0].area, 256);
    EXPECT_EQ(plan.holes[0].segments.size(), 4U);
    EXPECT_EQ(plan.holes.size(), s == &scene ? 1U : 2U);
    EXPECT_NE(plan.holes[0].standing, Standing::kHanging);
    EXPECT_TRUE(s == &scene || plan.holes[1].standing == Standing::kHanging);
    EXPECT_EQ(plan.left.size(), 1U);
    EXPECT_FALSE(plan.left[0].is_hole);
    EXPECT_EQ(plan.left[0].edges, 4);
  }
}

TEST(FindFreePiecesTest, OnlyInsideTheAreaAndTheCell) {
  PieceScene scene;
  scene.AddSquare(8, 9, 20, true);
  PlanInput input = scene.Input();
  input.area.rings = {{{1, 1}, {19, 1}, {19, 19}, {1, 19}}};
  EXPECT_FALSE(FindFreePieces(input).empty());
  input.area.rings = {{{1, 1}, {8.5, 1}, {8.5, 19}, {1, 19}}};
  EXPECT_TRUE(FindFreePieces(input).empty());
  input = scene.Input();
  input.grid.corner = Point2(8.5, 0);  // the tile reaches over its cell
  EXPECT_TRUE(FindFreePieces(input).empty());
}

// 20,000 pieces are taken where each is level with few others, and none where all are level.
TEST(FindFreePiecesTest, NoneWhereAskingTakesTooLong) {
  PieceScene scene;
  for (int k = 0; k < 20'000; ++k) scene.AddSquare(5 + 5e-4 * k, 5 + 5e-4 * k + 1e-4, 20, true);
  EXPECT_EQ(FindFreePieces(scene.Input()).at(kCell).size(), 20'000U);
  PieceScene level;
  for (int k = 0; k < 20'000; ++k) {
    level.AddSquare(5 + 5e-4 * k, 5 + 5e-4 * k + 1e-4, 20, true);
    for (size_t v = level.record.vertices.size() - 4; v < level.record.vertices.size(); ++v) {
      level.record.vertices[v].position.y() = v % 4 < 2 ? 8 : 9;
    }
  }
  EXPECT_TRUE(FindFreePieces(level.Input()).empty());
}

// The only boundary of a tile within a hole is that of a crown.
TEST(FreePiecesTest, ATileWithoutOtherBoundaryIsNoneThatFacesDown) {
  PieceScene scene;
  scene.record.edges.clear();
  scene.AddSquare(8, 9, 20, true);
  const Plan plan = MakePlan(scene.Input(), {});
  EXPECT_EQ(plan.outer_rims, 1);
  for (const LeftOpen& left : plan.left) EXPECT_EQ(left.reason.find("faces down"), std::string::npos) << left.reason;
}

// 2 m above the ground it is an island, with a wall.
TEST(FreePiecesTest, LowerPiecesAreIslands) {
  PieceScene scene;
  scene.AddSquare(8, 9, 2, true);
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_EQ(plan.holes.size(), 1U);
  EXPECT_EQ(plan.holes[0].area, 255);
  EXPECT_EQ(plan.holes[0].segments.size(), 8U);
}

}  // namespace
}  // namespace tilemend
