// A mesh with some faces turned over had "0 of 0 holes": the boundary around its hole changed its direction.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "client/mesh/array_mesh.h"
#include "client/mesh/mesh_filler.h"
#include "client/mesh/mesh_options.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kSide = 9;  // squares

struct Arrays {
  std::vector<double> vertices;
  std::vector<int32_t> faces;

  ArrayMesh Mesh() const { return ArrayMesh::Make(std::span(vertices), std::span(faces)).value(); }
};

// A plane with a hole of one square in its middle; `turned` by the number of a face.
Arrays PlaneWithHole(const std::function<bool(size_t)>& turned) {
  std::vector<double> vertices;
  std::vector<int32_t> faces;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) vertices.insert(vertices.end(), {double(x), double(y), 0});
  }
  const auto add = [&](int32_t a, int32_t b, int32_t c) {
    if (turned(faces.size() / 3)) std::swap(b, c);
    faces.insert(faces.end(), {a, b, c});
  };
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (x == kSide / 2 && y == kSide / 2) continue;
      const int32_t a = y * (kSide + 1) + x, d = a + kSide + 2;
      add(a, a + 1, d);
      add(a, d, d - 1);
    }
  }
  return {vertices, faces};
}

FilledMesh Fill(ArrayMesh& mesh) {
  auto spec = SpecFromTexts({{"water", kMeshWater}}, kOfFill);
  auto filled = FillMesh(mesh, MeshOptionsOf(*spec).value());
  EXPECT_TRUE(filled.ok()) << filled.status();
  return *std::move(filled);
}

TEST(FacesThatDisagreeTest, HideNoHole) {
  const Arrays plane = PlaneWithHole([](size_t) { return false; });
  ArrayMesh expected = plane.Mesh();
  EXPECT_THAT(Fill(expected).report.warnings, IsEmpty());
  for (const size_t every : {2, 3, 7}) {
    const Arrays given = PlaneWithHole([every](size_t face) { return face % every == 1; });
    ArrayMesh mesh = given.Mesh();
    const FilledMesh filled = Fill(mesh);
    EXPECT_EQ(filled.report.plan->holes.size(), 1) << every;
    EXPECT_THAT(filled.report.outcome.failures, IsEmpty());
    EXPECT_THAT(filled.report.warnings, ElementsAre(HasSubstr("faces are turned the other way")));
    const std::vector<int32_t> after = mesh.Filled().faces;
    EXPECT_TRUE(std::equal(given.faces.begin(), given.faces.end(), after.begin())) << "original faces stay as they are";
    EXPECT_EQ(after.size(), expected.Filled().faces.size());
  }
}

// The new faces have the front of most of the old ones.
TEST(FacesThatDisagreeTest, FillsLookTheWayOfMostFaces) {
  for (const bool most_are_turned : {false, true}) {
    const Arrays given = PlaneWithHole([&](size_t face) { return (face % 4 == 0) != most_are_turned; });
    ArrayMesh mesh = given.Mesh();
    Fill(mesh);
    const FilledArrays filled = mesh.Filled();
    const PointRows points(std::get<std::vector<double>>(filled.vertices));
    const TriangleRows faces(std::span<const int32_t>(filled.faces));
    ASSERT_GT(faces.size(), filled.originals);
    for (size_t t = filled.originals; t < faces.size(); ++t) {
      EXPECT_EQ(TwiceVectorArea(points, faces[t]).z() < 0, most_are_turned);
    }
  }
}

// A Moebius strip, closed to a Klein bottle, has no boundary that could be named.
TEST(FacesThatDisagreeTest, ASurfaceWithOneSideIsNamed) {
  constexpr int kLong = 8, kAround = 6;
  std::vector<double> vertices;
  std::vector<int32_t> faces;
  for (int i = 0; i < kLong * kAround; ++i)
    vertices.insert(vertices.end(), {double(i % kAround), double(i), double(i * i % 7)});
  const auto vertex = [](int along, int around) {
    const int at = along < kLong ? around : kAround - around;  // its end is glued on the other way round
    return along % kLong * kAround + at % kAround;
  };
  for (int i = 0; i < kLong; ++i) {
    for (int j = 0; j < kAround; ++j) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      faces.insert(faces.end(), {a, b, c, a, c, d});
    }
  }
  const Arrays given = {vertices, faces};
  ArrayMesh mesh = given.Mesh();
  const FilledMesh filled = Fill(mesh);
  EXPECT_THAT(filled.report.plan->holes, IsEmpty());
  EXPECT_THAT(filled.report.warnings, ElementsAre(HasSubstr("has one side only; orient its faces")));
}

}  // namespace
}  // namespace tilemend
