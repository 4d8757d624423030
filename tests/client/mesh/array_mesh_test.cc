#include "client/mesh/array_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>
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

std::vector<double> DoublesOf(const ArrayMesh& mesh) { return std::get<std::vector<double>>(mesh.Filled().vertices); }

TEST(ArrayMeshTest, ReadsNumbersOfAnyTypeWhereTheyLie) {
  const auto expect_in_place = [](auto vertices, auto faces) {
    const auto mesh = ArrayMesh::Make(std::span(std::as_const(vertices)), std::span(std::as_const(faces)));
    ASSERT_TRUE(mesh.ok()) << mesh.status();
    const HeldMesh held = mesh->Mesh().value();
    EXPECT_EQ(held.view.points.data(), vertices.data());
    EXPECT_EQ(held.view.triangles.data(), faces.data());
    EXPECT_EQ(held.view.points[2], Point3(1, 1, 0));
    EXPECT_EQ(held.view.triangles[1], (Triangle{0, 2, 3}));
    EXPECT_EQ(std::get<decltype(vertices)>(mesh->Filled().vertices), vertices);
    EXPECT_EQ(mesh->Filled().faces, kTwoFaces);
  };
  expect_in_place(kSquare, kTwoFaces);
  expect_in_place(kSquare, std::vector<int64_t>(kTwoFaces.begin(), kTwoFaces.end()));
  expect_in_place(kSquare, std::vector<uint64_t>(kTwoFaces.begin(), kTwoFaces.end()));
  expect_in_place(std::vector<float>(kSquare.begin(), kSquare.end()),
                  std::vector<uint32_t>(kTwoFaces.begin(), kTwoFaces.end()));
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
  EXPECT_EQ(std::get<std::vector<float>>(narrow->Filled().vertices)[12], 0.1F);
  EXPECT_EQ(DoublesOf(*wide)[12], 0.1);
  EXPECT_EQ(wide->Filled().originals, 2);
  EXPECT_THAT(wide->Filled().faces, ElementsAre(0, 1, 2, 0, 2, 3, 0, 1, 4));
}

TEST(ArrayMeshTest, ClearCountsWhatEachAreaTakesOut) {
  auto mesh = ArrayMesh::Make(std::span(kSquare), std::span(kTwoFaces));
  const ClearArea nowhere{PlanePolygon({{{5, 5}, {6, 5}, {6, 6}}}), 10};
  const ClearArea all{PlanePolygon({{{-1, -1}, {2, -1}, {2, 2}, {-1, 2}}}), 10};
  const auto cleared = mesh->Clear(std::vector<ClearArea>{nowhere, all});
  ASSERT_TRUE(cleared.ok());
  EXPECT_THAT(*cleared, ElementsAre(0, 2));
  EXPECT_TRUE(mesh->Filled().faces.empty());
  EXPECT_EQ(mesh->Filled().originals, 0);
  EXPECT_EQ(DoublesOf(*mesh), kSquare);
}

}  // namespace
}  // namespace tilemend
