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
