#include "common/mesh/mesh_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

const TriMesh kMesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, -2}}, {{0, 1, 2}, {2, 1, 3}}};

TEST(MeshViewTest, ReadsAMeshWhereItLies) {
  const MeshView view = kMesh;
  EXPECT_EQ(view.points.data(), kMesh.points.data());
  EXPECT_EQ(view.triangles.data(), kMesh.triangles.data());
  EXPECT_EQ(std::vector<Point3>(view.points.begin(), view.points.end()), kMesh.points);
  EXPECT_EQ(std::vector<Triangle>(view.triangles.begin(), view.triangles.end()), kMesh.triangles);
  EXPECT_FALSE(view.points.is_float32());
}

TEST(MeshViewTest, ReadsFloat32AsDoubles) {
  const std::vector<float> numbers = {0, 0, 0, 0.1F, 0.2F, 0.3F};
  const PointRows points{std::span(numbers)};
  EXPECT_TRUE(points.is_float32());
  ASSERT_EQ(points.size(), 2);
  EXPECT_EQ(points[1], Point3(double{0.1F}, double{0.2F}, double{0.3F}));
}

template <typename Index>
std::vector<Triangle> ReadAs() {
  const std::vector<Index> indices = {0, 1, 2, 2, 2147483647, 3};
  const TriangleRows rows{std::span(indices)};
  return {rows.begin(), rows.end()};
}

TEST(MeshViewTest, ReadsIndicesOfAnyWidth) {
  const auto expected = ElementsAre(Triangle{0, 1, 2}, Triangle{2, 2147483647, 3});
  EXPECT_THAT(ReadAs<int32_t>(), expected);
  EXPECT_THAT(ReadAs<uint32_t>(), expected);
  EXPECT_THAT(ReadAs<int64_t>(), expected);
  EXPECT_THAT(ReadAs<uint64_t>(), expected);
}

TEST(MeshViewTest, CopiesOfTrianglesHaveTheirExactSize) {
  std::vector<int64_t> indices;
  for (int64_t i = 0; i < 3 * 1000; ++i) indices.push_back(i % 4);
  const TriangleRows wide{std::span(std::as_const(indices))};
  const std::vector<Triangle> copy = wide.Copy();
  EXPECT_EQ(copy.capacity(), 1000);
  EXPECT_EQ(copy, std::vector<Triangle>(wide.begin(), wide.end()));
  EXPECT_EQ(MeshView(kMesh).triangles.Copy(), kMesh.triangles);
  EXPECT_TRUE(TriangleRows().Copy().empty());
}

TEST(MeshViewTest, RowsOfTheTypesOfAMeshAreSpans) {
  const MeshView view = kMesh;
  EXPECT_EQ(view.points.AsSpan()->data(), kMesh.points.data());
  EXPECT_EQ(view.points.AsSpan()->size(), kMesh.points.size());
  EXPECT_EQ(view.triangles.AsSpan()->data(), kMesh.triangles.data());
  EXPECT_EQ(view.triangles.AsSpan()->size(), kMesh.triangles.size());
  const std::vector<float> narrow(3);
  const std::vector<int64_t> wide(3);
  EXPECT_FALSE(PointRows{std::span(narrow)}.AsSpan().has_value());
  EXPECT_FALSE(TriangleRows{std::span(wide)}.AsSpan().has_value());
}

TEST(MeshViewTest, NothingHasNoRows) {
  const MeshView view = TriMesh();
  EXPECT_EQ(view.points.size(), 0);
  EXPECT_EQ(view.triangles.begin(), view.triangles.end());
}

TEST(MeshViewTest, AreasAreThoseOfThePositions) {
  const MeshView view = kMesh;
  EXPECT_EQ(TwiceVectorArea(view.points, kMesh.triangles[0]), TwiceVectorArea(kMesh.points, kMesh.triangles[0]));
}

}  // namespace
}  // namespace tilemend
