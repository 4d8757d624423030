#include "tests/support/scene_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/grid/grid_fit.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

double PlanArea(const TriMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point3 u = mesh.points[t[1]] - mesh.points[t[0]];
    const Point3 v = mesh.points[t[2]] - mesh.points[t[0]];
    EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0) << "a triangle faces down";
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  return area;
}

// Boundary edges of the mesh that do not lie on the outline of the rectangle from 0, 0 to `size`.
int InnerBoundaryEdges(const TriMesh& mesh, const Point2& size) {
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++edges[std::minmax({t[k], t[(k + 1) % 3]})];
  }
  const auto on_rim = [&](int a, int b) {
    for (const int axis : {0, 1}) {
      for (const double line : {0.0, size[axis]}) {
        if (mesh.points[a][axis] == line && mesh.points[b][axis] == line) return true;
      }
    }
    return false;
  };
  return static_cast<int>(std::count_if(edges.begin(), edges.end(), [&](const auto& edge) {
    return edge.second == 1 && !on_rim(edge.first.first, edge.first.second);
  }));
}

SceneMakerOptions AllHoles(Cut cut) {
  SceneMakerOptions options;
  options.cut = cut;
  options.lakes = options.islands = options.river = true;
  options.lake_share = 0.15;
  options.small_per_cell = 2;
  options.ellipses = {{{100, 100}, {20, 10}}};
  options.boxes = {{{10, 10}, {20, 30}}};
  options.empty = {{3, 3}};
  options.out_of_area = {{0, 3}};
  return options;
}

class SceneMakerTest : public testing::TestWithParam<Cut> {};
INSTANTIATE_TEST_SUITE_P(Cuts, SceneMakerTest, testing::Values(Cut::kClipped, Cut::kRagged),
                         [](const auto& test) { return NameOf(test.param); });

TEST_P(SceneMakerTest, CoversTheSceneOnceWithoutHoles) {
  SceneMakerOptions options;
  options.cut = GetParam();
  options.cols = 3;
  options.rows = 2;
  const MadeScene scene = MakeScene(options);
  ASSERT_EQ(scene.tiles.size(), 6u);
  const TriMesh merged = MergeTiles(scene);
  EXPECT_NEAR(PlanArea(merged), 150 * 100, 1e-6);
  EXPECT_EQ(InnerBoundaryEdges(merged, {150, 100}), 0) << "tiles share their border vertices bit for bit";
  EXPECT_TRUE(scene.removed.empty());
}

TEST_P(SceneMakerTest, RemovesTheTrianglesWhoseCentroidsAreInHoles) {
  const MadeScene scene = MakeScene(AllHoles(GetParam()));
  EXPECT_EQ(scene.tiles.size(), 15u);
  for (const MadeTile& tile : scene.tiles) {
    for (const Triangle& t : tile.mesh.triangles) {
      const Point3 m = (tile.mesh.points[t[0]] + tile.mesh.points[t[1]] + tile.mesh.points[t[2]]) / 3;
      EXPECT_FALSE(scene.is_in_hole(m.x(), m.y()));
      EXPECT_EQ(std::floor(m.x() / 50), tile.cell.col);
      EXPECT_EQ(std::floor(m.y() / 50), tile.cell.row);
    }
    EXPECT_EQ(tile.mesh.triangles.empty(), tile.cell == (CellId{3, 3})) << ToString(tile.cell);
  }
  EXPECT_GT(InnerBoundaryEdges(MergeTiles(scene), {200, 200}), 100);
  EXPECT_GT(scene.removed.size(), 500u);
  EXPECT_TRUE(scene.is_in_hole(100, 100));
  EXPECT_TRUE(scene.is_in_hole(15, 20));
}

TEST_P(SceneMakerTest, IsTheSameForTheSameOptions) {
  const MadeScene a = MakeScene(AllHoles(GetParam()));
  const MadeScene b = MakeScene(AllHoles(GetParam()));
  for (size_t i = 0; i < a.tiles.size(); ++i) EXPECT_EQ(PlyBytes(a.tiles[i].mesh), PlyBytes(b.tiles[i].mesh));
  SceneMakerOptions other = AllHoles(GetParam());
  other.seed = 2;
  EXPECT_NE(PlyBytes(MakeScene(other).tiles[0].mesh), PlyBytes(a.tiles[0].mesh));
}

TEST_P(SceneMakerTest, HasTheGridThatItsTilesTell) {
  const MadeScene scene = MakeScene(AllHoles(GetParam()));
  std::vector<PlacedTile> placed;
  for (const MadeTile& tile : scene.tiles) {
    if (tile.mesh.points.empty()) continue;
    Box box{tile.mesh.points[0], tile.mesh.points[0]};
    for (const Point3& p : tile.mesh.points) box = {box.lo.cwiseMin(p), box.hi.cwiseMax(p)};
    placed.push_back({tile.cell, ToString(tile.cell), box});
  }
  const auto grid = FitGrid(placed);
  ASSERT_TRUE(grid.ok()) << grid.status();
  EXPECT_EQ(grid->cell_size, scene.grid.cell_size);
  EXPECT_EQ(grid->corner, scene.grid.corner);
}

TEST(SceneMakerHeightTest, IsTheHeightOfTheVertices) {
  SceneMakerOptions options;
  options.boxes = {{{40, 40}, {60, 60}}};
  const MadeScene scene = MakeScene(options);
  double lowest = 1e9, highest = -1e9;
  for (const Point3& p : MergeTiles(scene).points) {
    EXPECT_NEAR(scene.height(p.x(), p.y()), p.z(), 1e-4);
    lowest = std::min(lowest, p.z());
    highest = std::max(highest, p.z());
  }
  EXPECT_GT(highest - lowest, 0.3 * options.relief);
  EXPECT_LT(highest - lowest, 1.5 * options.relief);
  ASSERT_FALSE(scene.removed.empty());
  for (const Point3& p : scene.removed) EXPECT_NEAR(scene.height(p.x(), p.y()), p.z(), 1e-4);
}

TEST(SceneMakerHeightTest, DoesNotDependOnTheCells) {
  SceneMakerOptions options;
  options.lakes = options.river = true;
  options.feature_size = 50;
  const MadeScene tiled = MakeScene(options);
  options.cols = options.rows = 1;
  options.cell_size = 200;
  const MadeScene whole = MakeScene(options);
  int differences = 0;
  for (double y = 1.3; y < 200; y += 3.7) {
    for (double x = 0.7; x < 200; x += 3.1) {
      EXPECT_EQ(tiled.height(x, y), whole.height(x, y));
      differences += tiled.is_in_hole(x, y) != whole.is_in_hole(x, y);
    }
  }
  EXPECT_EQ(differences, 0);
}

SceneMakerOptions Overlapping(int32_t pieces) {
  SceneMakerOptions options;
  options.cut = Cut::kOverlap;
  options.cols = 3;
  options.rows = 2;
  options.margin = 0.25;
  options.pieces = pieces;
  return options;
}

class OverlapTest : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Pieces, OverlapTest, testing::Values(1, 2, 3));

TEST_P(OverlapTest, EveryPieceReachesOverItsSquareByTheMargin) {
  const MadeScene scene = MakeScene(Overlapping(GetParam()));
  ASSERT_EQ(scene.tiles.size(), 6u);
  const double side = 50.0 / GetParam() + 2 * 0.25;
  for (const MadeTile& tile : scene.tiles) {
    Box box{tile.mesh.points[0], tile.mesh.points[0]};
    for (const Point3& p : tile.mesh.points) box = {box.lo.cwiseMin(p), box.hi.cwiseMax(p)};
    const Point2 lo = 50 * Point2(tile.cell.col, tile.cell.row);
    EXPECT_NEAR((box.lo.head<2>() - lo + Point2(0.25, 0.25)).norm(), 0, 1e-5);
    EXPECT_NEAR((box.hi.head<2>() - lo - Point2(50.25, 50.25)).norm(), 0, 1e-5);
    EXPECT_NEAR(PlanArea(tile.mesh), side * side * GetParam() * GetParam(), 1e-3);
  }
}

TEST_P(OverlapTest, NoVertexIsShared) {
  const MadeScene scene = MakeScene(Overlapping(GetParam()));
  size_t vertices = 0;
  for (const MadeTile& tile : scene.tiles) vertices += tile.mesh.points.size();
  EXPECT_EQ(MergeTiles(scene).points.size(), vertices);
}

TEST_P(OverlapTest, HolesGoOverTheRimOfTheSceneAndEndAtTheSidesOfTheirOnlyCell) {
  SceneMakerOptions options = Overlapping(GetParam());
  options.ellipses = {{{150, 25}, {12, 12}}, {{50, 75}, {12, 12}, CellId{0, 1}}};
  const MadeScene scene = MakeScene(options);
  EXPECT_TRUE(scene.is_in_hole(150.2, 25));
  EXPECT_TRUE(scene.is_in_hole(49.9, 75));
  EXPECT_FALSE(scene.is_in_hole(50.1, 75));
  for (const MadeTile& tile : scene.tiles) {
    for (const Triangle& t : tile.mesh.triangles) {
      const Point3 m = (tile.mesh.points[t[0]] + tile.mesh.points[t[1]] + tile.mesh.points[t[2]]) / 3;
      EXPECT_FALSE(scene.is_in_hole(m.x(), m.y()));
    }
  }
}

TEST(OverlapNoiseTest, NeighboursDisagreeByTheNoiseAlone) {
  SceneMakerOptions options = Overlapping(1);
  options.noise = 0.1;
  double largest = 0;
  const MadeScene scene = MakeScene(options);
  for (const Point3& p : MergeTiles(scene).points)
    largest = std::max(largest, std::abs(p.z() - scene.height(p.x(), p.y())));
  EXPECT_GT(largest, 0.045);
  EXPECT_LE(largest, 0.0501);
}

TEST(MadeHolesTest, ClosedHolesLieInTheirCells) {
  SceneMakerOptions options;
  options.boxes = {{{40, 40}, {160, 160}}};
  options.spacing = 1;
  options.closed = 7;
  options.cut = Cut::kOverlap;
  const MadeScene scene = MakeScene(options);
  options.closed = 0;
  const MadeScene without = MakeScene(options);
  EXPECT_GT(scene.removed.size(), without.removed.size() + 7);
  for (int k = 0; k <= 200; ++k) {
    for (const double line : {50.0, 100.0, 150.0}) {
      EXPECT_EQ(scene.is_in_hole(k, line), without.is_in_hole(k, line));
      EXPECT_EQ(scene.is_in_hole(line, k), without.is_in_hole(line, k));
    }
  }
}

TEST(WriteSceneTest, IsReadByLoadScene) {
  const TemporaryFolder folder;
  const MadeScene made = MakeScene(AllHoles(Cut::kClipped));
  ASSERT_TRUE(WriteScene(made, folder.path()).ok());
  const auto scene = LoadScene(folder.path(), nullptr);
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->tiles.size(), 15u);
  EXPECT_EQ(scene->tiles.back().path, "") << "the empty cell";
  EXPECT_EQ(scene->grid.cell_size, Point2(50, 50));
  EXPECT_EQ(ReadFile(folder / "tiles/Tile_+001_+000.ply").value(), PlyBytes(made.tiles[1].mesh));
  EXPECT_TRUE(ReadFile(folder / "truth.csv").value().starts_with("x,y,z\n"));
}

}  // namespace
}  // namespace tilemend
