#include "worker/ground/lowest_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tilemend {
namespace {

float At(const GroundRaster& raster, int32_t col, int32_t row) { return raster.heights[raster.IndexOf(col, row)]; }

TEST(LowestSurfaceTest, ALargeTriangleCountsInEverySquareThatItCovers) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {10, 0, 10}, {0, 10, 0}};
  mesh.triangles = {{0, 1, 2}};
  const GroundRaster raster = LowestSurface(mesh, 1);
  EXPECT_EQ(raster.cols, 11);
  EXPECT_NEAR(At(raster, 3, 3), 3.25, 1e-6);  // the height is x; a quarter of a square from its side
  EXPECT_TRUE(std::isnan(At(raster, 8, 8)));
  EXPECT_EQ(At(raster, 10, 0), 10);  // a vertex
}

TEST(LowestSurfaceTest, TheLowestOfSeveralSurfacesCounts) {
  TriMesh mesh;
  for (const double z : {5.0, 2.0, 9.0}) {
    const auto first = static_cast<int32_t>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), {{0, 0, z}, {4, 0, z}, {0, 4, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(At(LowestSurface(mesh, 1), 1, 1), 2);
}

// Triangles that reach into two or four squares, of which the lower corner is in one: the other has to be lowered to
// the triangle's height at its places.
TEST(LowestSurfaceTest, ASmallTriangleLowersTheSquaresBesideItsLowestCorner) {
  TriMesh mesh;
  mesh.points = {{0.1, 0.1, 0}, {1.9, 0.2, 9}, {0.2, 1.9, 9}, {1.6, 1.6, 20}};
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
  const GroundRaster raster = LowestSurface(mesh, 1);
  EXPECT_EQ(At(raster, 0, 0), 0);
  EXPECT_LT(At(raster, 1, 0), 8);
  EXPECT_GT(At(raster, 1, 0), 5);
  EXPECT_LT(At(raster, 0, 1), 8);
  EXPECT_GT(At(raster, 1, 1), 10);
  EXPECT_LT(At(raster, 1, 1), 19) << "a place of the second triangle";
}

TEST(LowestSurfaceTest, SquaresLieOnOneLatticeAlsoBelowZero) {
  TriMesh mesh;
  mesh.points = {{-2.5, -0.5, 1}, {-1.2, -0.5, 1}, {-2.5, 0.5, 1}};
  mesh.triangles = {{0, 1, 2}};
  const GroundRaster raster = LowestSurface(mesh, 1);
  EXPECT_EQ(raster.col, -3);
  EXPECT_EQ(raster.row, -1);
  EXPECT_EQ(raster.cols, 2);
  EXPECT_EQ(raster.rows, 2);
}

TEST(LowestSurfaceTest, AWallCountsWithItsVertices) {
  TriMesh mesh;
  mesh.points = {{0.5, 0.5, 3}, {5.5, 0.5, 3}, {5.5, 0.5, 8}};
  mesh.triangles = {{0, 1, 2}};
  const GroundRaster raster = LowestSurface(mesh, 1);
  EXPECT_EQ(At(raster, 0, 0), 3);
  EXPECT_EQ(At(raster, 5, 0), 3);
}

TEST(LowestSurfaceTest, NothingIsMadeOfNoTrianglesAndOfEndlessOnes) {
  EXPECT_TRUE(LowestSurface({}, 1).empty());
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1e9, 0, 0}, {0, 1e9, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_TRUE(LowestSurface(mesh, 1).empty());
  mesh.points[1].x() = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(LowestSurface(mesh, 1).empty());
}

TEST(RasterSquareTest, IsAMetreUntilACellHasTooManySquares) {
  EXPECT_EQ(RasterSquareFor(250, 100), 1);
  EXPECT_EQ(RasterSquareFor(1024, 1), 1);
  EXPECT_EQ(RasterSquareFor(1025, 1), 2);
  EXPECT_EQ(RasterSquareFor(1, 30000), 32);
}

}  // namespace
}  // namespace tilemend
