#include "worker/survey/orient_faces.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

TEST(OrientFacesTest, TurnsTheFewerOnesBackInEachPiece) {
  const TriMesh expected = Unwelded(PictureMesh({"####..###", "#..#..###", "####..###"}));
  TriMesh mesh = expected;
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  std::swap(mesh.triangles.back()[1], mesh.triangles.back()[2]);
  EXPECT_EQ(OrientFaces(PointRows(mesh.points), mesh.triangles), 2);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(OrientFaces(PointRows(mesh.points), mesh.triangles), 0);
}

TEST(OrientFacesTest, LeavesASurfaceWithOneSide) {
  TriMesh strip;  // of five triangles, the shortest
  strip.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 2}, {0, 2, 3}};
  strip.triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}};
  const TriMesh before = strip;
  EXPECT_EQ(OrientFaces(PointRows(strip.points), strip.triangles), 0);
  EXPECT_EQ(strip.triangles, before.triangles);
}

}  // namespace
}  // namespace tilemend
