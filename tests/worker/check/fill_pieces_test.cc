#include "worker/check/fill_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(FillPiecesTest, PiecesShareNoEdge) {
  const Triangle a = {0, 1, 2}, b = {0, 2, 3}, at_a_vertex = {3, 4, 5};
  EXPECT_THAT(PiecesByEdges({a, at_a_vertex, b}), ElementsAre(ElementsAre(a, b), ElementsAre(at_a_vertex)));
}

TEST(FillPiecesTest, NoTrianglesHaveNoPieces) { EXPECT_THAT(PiecesByEdges({}), IsEmpty()); }

using ::testing::SizeIs;

// Two squares that touch at a vertex, each of two triangles; every triangle has its own corners.
TEST(FillPiecesTest, FillsAreConnectedOverEdges) {
  TriMesh mesh;
  for (const double at : {0.0, 1.0}) {
    const Point3 a(at, at, 0), b(at + 1, at, 0), c(at + 1, at + 1, 0), d(at, at + 1, 0);
    for (const Point3& p : {a, b, c, a, c, d}) mesh.points.push_back(p);
  }
  mesh.triangles = {{0, 1, 2}, {6, 7, 8}, {3, 4, 5}, {9, 10, 11}};
  const TileFills fills = FillsOf(mesh, {true, true, true, true});
  EXPECT_THAT(fills.of_triangle, ElementsAre(0, 1, 0, 1));
  EXPECT_THAT(fills.rims, ElementsAre(SizeIs(4), SizeIs(4)));
  const TileFills without = FillsOf(mesh, {true, false, false, true});
  EXPECT_THAT(without.of_triangle, ElementsAre(0, -1, -1, 1));
  EXPECT_THAT(without.rims, ElementsAre(SizeIs(3), SizeIs(3)));
  EXPECT_THAT(FillsOf(mesh, {false, false, false, false}).rims, IsEmpty());
}

// The upright triangle stands on the diagonal of the square.
TEST(FillPiecesTest, AnEdgeWithThreeAddedTrianglesConnectsNothing) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 4}};
  const TileFills fills = FillsOf(mesh, {true, true, true});
  EXPECT_THAT(fills.of_triangle, ElementsAre(0, 1, 2));
  EXPECT_THAT(fills.rims, ElementsAre(SizeIs(2), SizeIs(2), SizeIs(2)));
}

TEST(FillPiecesTest, AddedAreaIsThatOfTheOutline) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 5}, {2, 2, 0}, {0, 2, 1}, {1, 1, 30}, {9, 0, 0}, {10, 0, 0}, {10, 1, 0}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 1, 2}, {5, 6, 7}};
  const std::vector<bool> added = {true, true, true, true, false, true};
  EXPECT_DOUBLE_EQ(AddedAreaWithin({0, 0}, {4, 4}, mesh, added).from_above, 4);
  EXPECT_GT(AddedAreaWithin({0, 0}, {4, 4}, mesh, added).in_space, 4);
  mesh.points[4] = {5, 1, 3};  // a fold adds nothing: one triangle faces down
  EXPECT_DOUBLE_EQ(AddedAreaWithin({0, 0}, {8, 8}, mesh, added).from_above, 4);
  EXPECT_DOUBLE_EQ(AddedAreaWithin({8, 0}, {12, 4}, mesh, added).from_above, 0.5);
}

}  // namespace
}  // namespace tilemend
