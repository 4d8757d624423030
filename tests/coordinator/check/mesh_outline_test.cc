#include "coordinator/check/mesh_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

constexpr uint64_t kKey = 0x9e3779b97f4a7c15;

TriMesh Tetrahedron() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TriMesh OpenTetrahedron() {
  TriMesh mesh = Tetrahedron();
  mesh.triangles.pop_back();
  return mesh;
}

TEST(OutlineOfTest, AClosedBodyHasNone) {
  EXPECT_THAT(OutlineOf(TriMesh()), IsEmpty());
  TriMesh mesh = Tetrahedron();
  EXPECT_THAT(OutlineOf(mesh), IsEmpty());
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_THAT(OutlineOf(mesh), IsEmpty()) << "a triangle with a corner twice bounds nothing";
}

TEST(OutlineOfTest, HasTheEdgesOfATriangleThatIsMissing) {
  EXPECT_THAT(OutlineOf(OpenTetrahedron()), ElementsAre(Pair(0, 2), Pair(0, 3), Pair(2, 3)));
}

TEST(OutlineOfTest, CountsCopiesOnce) {
  TriMesh mesh = OpenTetrahedron();
  mesh.triangles.push_back({2, 1, 0});
  EXPECT_EQ(OutlineOf(mesh), OutlineOf(OpenTetrahedron()));
}

TEST(OutlineOfTest, NamesDoubledVerticesByTheLowest) {
  TriMesh mesh = Tetrahedron();
  mesh.points.push_back(mesh.points[3]);
  mesh.triangles[3][2] = 4;
  EXPECT_THAT(OutlineOf(mesh), IsEmpty());
  mesh.triangles.erase(mesh.triangles.begin() + 1);
  EXPECT_THAT(OutlineOf(mesh), ElementsAre(Pair(0, 1), Pair(0, 3), Pair(1, 3)));
}

TEST(OutlineOfTest, LeavesOutEdgesOfThreeTriangles) {
  TriMesh mesh = OpenTetrahedron();
  mesh.points.emplace_back(5, 5, 5);
  mesh.triangles.push_back({0, 1, 4});
  EXPECT_THAT(OutlineOf(mesh), ElementsAre(Pair(0, 2), Pair(0, 3), Pair(0, 4), Pair(1, 4), Pair(2, 3)));
}

uint64_t SumOf(const TriMesh& mesh, const std::vector<OutlineEdge>& edges) {
  uint64_t sum = 0;
  for (const auto& [a, b] : edges) sum ^= OutlineSumOfEdge(mesh.points[a], mesh.points[b], kKey);
  return sum;
}

TEST(OutlineSumTest, IsThatOfTheOutline) {
  EXPECT_EQ(OutlineSumOf(Tetrahedron(), kKey).sum, 0U);
  TriMesh mesh = OpenTetrahedron();
  EXPECT_EQ(OutlineSumOf(mesh, kKey).sum, SumOf(mesh, OutlineOf(mesh)));
  EXPECT_NE(OutlineSumOf(mesh, kKey).sum, OutlineSumOf(mesh, kKey + 1).sum);
  mesh.points.emplace_back(-0.0, 0.0, 1.0);  // where vertex 3 is
  mesh.triangles[1][2] = 4;
  EXPECT_EQ(OutlineSumOf(mesh, kKey).sum, SumOf(mesh, {{0, 2}, {0, 3}, {2, 3}}));
  EXPECT_NE(OutlineSumOf(mesh, kKey).sum, SumOf(mesh, {{0, 2}, {0, 3}}));
}

TEST(OutlineSumTest, CountsFlatTrianglesAndLeavesThemOut) {
  TriMesh mesh = Tetrahedron();
  mesh.triangles.push_back({0, 0, 1});
  EXPECT_EQ(OutlineSumOf(mesh, kKey).sum, 0U);
  EXPECT_EQ(OutlineSumOf(mesh, kKey).flat_triangles, 1);
}

}  // namespace
}  // namespace tilemend
