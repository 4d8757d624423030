#include "client/mesh/array_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<double> kSquare = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<int32_t> kTwoFaces = {0, 1, 2, 0, 2, 3};

absl::StatusOr<ArrayMesh> Made(const std::vector<double>& vertices, const std::vector<int64_t>& faces) {
  return ArrayMesh::Make(std::span(vertices), std::span(faces));
}

TEST(ArrayMeshTest, CopiesTheNumbers) {
  const auto mesh = ArrayMesh::Make(std::span(kSquare), std::span(kTwoFaces));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_THAT(mesh->mesh().points, ElementsAre(Point3(0, 0, 0), Point3(1, 0, 0), Point3(1, 1, 0), Point3(0, 1, 0)));
  EXPECT_THAT(mesh->mesh().triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_EQ(mesh->originals(), 2);
}

TEST(ArrayMeshTest, NamesTheNumberThatIsWrong) {
  std::vector<double> vertices = kSquare;
  vertices[7] = std::nan("");
  EXPECT_EQ(Made(vertices, {}).status().message(),
            "vertices[2, 1] is nan: expected a finite number between -1e9 and 1e9");
  vertices[7] = -1.5e9;
  EXPECT_THAT(std::string(Made(vertices, {}).status().message()), HasSubstr("vertices[2, 1] is -1.5e+09"));
  EXPECT_EQ(Made(kSquare, {0, 1, 4}).status().message(),
            "faces[0, 2] is 4: expected an index from 0 to 3, as there are 4 vertices");
  EXPECT_THAT(std::string(Made(kSquare, {0, 1, 2, 0, -1, 2}).status().message()), HasSubstr("faces[1, 1] is -1"));
  EXPECT_EQ(Made({}, {}).status().message(), "vertices: there are none");
  const std::vector<uint64_t> largest = {0, std::numeric_limits<uint64_t>::max(), 1};
  EXPECT_FALSE(ArrayMesh::Make(std::span(kSquare), std::span(largest)).ok());
}

TEST(ArrayMeshTest, NewCoordinatesAreRoundedToTheNumberTypeOfTheVertices) {
  const std::vector<float> vertices(kSquare.begin(), kSquare.end());
  auto narrow = ArrayMesh::Make(std::span(vertices), std::span(kTwoFaces));
  auto wide = ArrayMesh::Make(std::span(kSquare), std::span(kTwoFaces));
  FilePatch patch;
  patch.new_points = {{0.1, 0.2, 0.3}};
  patch.triangles = {{0, 1, 4}};
  ASSERT_TRUE(narrow->Append(patch).ok());
  ASSERT_TRUE(wide->Append(patch).ok());
  EXPECT_EQ(narrow->mesh().points[4].x(), static_cast<double>(0.1F));
  EXPECT_EQ(wide->mesh().points[4].x(), 0.1);
  EXPECT_EQ(wide->originals(), 2);
  EXPECT_EQ(wide->mesh().triangles.size(), 3);
}

TEST(ArrayMeshTest, ClearCountsWhatEachAreaTakesOut) {
  auto mesh = ArrayMesh::Make(std::span(kSquare), std::span(kTwoFaces));
  const ClearArea nowhere{PlanePolygon({{{5, 5}, {6, 5}, {6, 6}}}), 10};
  const ClearArea all{PlanePolygon({{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}}), 10};
  const auto cleared = mesh->Clear(std::vector<ClearArea>{nowhere, all});
  ASSERT_TRUE(cleared.ok());
  EXPECT_THAT(*cleared, ElementsAre(0, 2));
  EXPECT_TRUE(mesh->mesh().triangles.empty());
  EXPECT_EQ(mesh->originals(), 0);
  EXPECT_EQ(mesh->mesh().points.size(), 4);
}

}  // namespace
}  // namespace tilemend
