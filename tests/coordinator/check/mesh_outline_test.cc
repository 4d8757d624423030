#include "coordinator/check/mesh_outline.h"

#include <gtest/gtest.h>

#include <utility>

namespace tilemend {
namespace {

TriMesh Tetrahedron() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TEST(HasBoundaryTest, AClosedBodyHasNone) {
  EXPECT_FALSE(HasBoundary(TriMesh()));
  TriMesh mesh = Tetrahedron();
  EXPECT_FALSE(HasBoundary(mesh));
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_FALSE(HasBoundary(mesh)) << "a triangle with a corner twice bounds nothing";
}

TEST(HasBoundaryTest, WithOneTriangleLessItHas) {
  TriMesh mesh = Tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_TRUE(HasBoundary(mesh));
}

TEST(HasBoundaryTest, DoubledVerticesAreNoBoundary) {
  TriMesh mesh = Tetrahedron();
  mesh.points.push_back(mesh.points[3]);
  mesh.triangles[3][2] = 4;
  EXPECT_FALSE(HasBoundary(mesh));
}

}  // namespace
}  // namespace tilemend
