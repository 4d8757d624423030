#include "worker/weld/welding_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <type_traits>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsNull;
using ::testing::NotNull;

// Two triangles beside a line, 0 1 2 left of it and 3 4 5 right of it; 3 beside 1 and 4 beside 0.
TriMesh TwoTriangles() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0.1, 1, 0}, {0.1, 0, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  return mesh;
}

using Span = std::span<const int32_t>;
static_assert(std::is_constructible_v<WeldingMesh, const TriMesh&, Span, Span>);
static_assert(!std::is_constructible_v<WeldingMesh, TriMesh, Span, Span>, "it would view what is gone");

const std::vector<int32_t> kAll = {0, 1, 2, 3, 4, 5};

TEST(WeldingMeshTest, MergesPlacesOneAfterTheOther) {
  const TriMesh mesh = TwoTriangles();
  WeldingMesh welding(mesh, kAll, {});
  ASSERT_THAT(welding.MergeFault(0, 4), IsNull());
  welding.Merge(0, 4);
  EXPECT_EQ(welding.StaysAs(4), 0);
  EXPECT_THAT(welding.MembersOf(0), ElementsAre(0, 4));
  EXPECT_EQ(welding.OpenEdges().size(), 6u);
  ASSERT_THAT(welding.MergeFault(1, 3), IsNull());
  welding.Merge(1, 3);
  EXPECT_THAT(welding.triangles(), ElementsAre(Triangle{0, 1, 2}, Triangle{1, 0, 5}));
  EXPECT_EQ(welding.OpenEdges().size(), 4u);
}

TEST(WeldingMeshTest, FindsFaults) {
  const TriMesh mesh = TwoTriangles();
  WeldingMesh welding(mesh, kAll, {});
  EXPECT_STREQ(welding.MergeFault(0, 1), "a face would lose its area");
  EXPECT_THAT(welding.MergeFault(2, 4), IsNull());
  TriMesh turned = mesh;
  turned.triangles[1] = {4, 3, 5};
  EXPECT_STREQ(WeldingMesh(turned, kAll, {}).MergeFault(0, 4), "the surfaces there face opposite ways");
  // Vertex 5 onto the far side of its own triangle.
  EXPECT_STREQ(welding.MergeFault(2, 5), "a face would turn over");
}

TEST(WeldingMeshTest, SplitsATriangleAtAPlaceBesideItsEdge) {
  TriMesh mesh = TwoTriangles();
  mesh.points[3] = {0, 0.5, 0};
  mesh.points[4] = {0, 0, 0};
  const std::vector<int32_t> boundary = {0, 1, 2, 3, 5};
  WeldingMesh welding(mesh, boundary, {});
  const int32_t place = welding.boundary()[3];
  ASSERT_THAT(welding.SplitFault({0, 0}, place), IsNull());
  welding.Split({0, 0}, place);
  EXPECT_THAT(welding.triangles(), ElementsAre(Triangle{0, 3, 2}, Triangle{3, 4, 5}, Triangle{3, 1, 2}));
  EXPECT_EQ(welding.OpenEdges().size(), 5u);
  EXPECT_THAT(welding.SplitFault({2, 1}, place), NotNull()) << "the edge is there already";
}

}  // namespace
}  // namespace tilemend
