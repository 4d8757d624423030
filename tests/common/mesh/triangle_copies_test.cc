#include "common/mesh/triangle_copies.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(WithoutCopiesTest, KeepsTheFirstOfEachWhateverItsFirstCorner) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {1, 2, 0}, {3, 2, 1}};
  EXPECT_EQ(WithoutCopies(mesh), (std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}));
}

TEST(WithoutCopiesTest, BacksAndTrianglesOfOtherPiecesAreNoCopies) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 2}, {3, 4, 5}};
  EXPECT_EQ(WithoutCopies(mesh), std::nullopt);
}

}  // namespace
}  // namespace tilemend
