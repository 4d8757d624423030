#include "common/codec/polygons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

MeshFile With(const std::vector<int32_t>& corners) {
  MeshFile file;
  std::vector<Triangle> cut;
  AddPolygon(corners, file, cut);
  return file;
}

TEST(AddPolygonTest, MakesAFanAroundTheFirstCorner) {
  EXPECT_THAT(With({4, 5, 6}).mesh.triangles, ElementsAre(Triangle{4, 5, 6}));
  EXPECT_EQ(With({4, 5, 6}).polygon_count, 0);
  const MeshFile file = With({9, 1, 2, 3, 4});
  EXPECT_THAT(file.mesh.triangles, ElementsAre(Triangle{9, 1, 2}, Triangle{9, 2, 3}, Triangle{9, 3, 4}));
  EXPECT_EQ(file.polygon_count, 1);
}

TEST(AddPolygonTest, AddsNothingThatBoundsNoSurface) {
  EXPECT_THAT(With({}).mesh.triangles, IsEmpty());
  EXPECT_THAT(With({1, 2}).mesh.triangles, IsEmpty());
  EXPECT_THAT(With({1, 2, 1}).mesh.triangles, IsEmpty());
}

TEST(AddPolygonTest, SeesARepeatedVertexOfFewAndOfManyCorners) {
  for (const int count : {4, 8, 9, 100}) {
    std::vector<int32_t> corners(static_cast<size_t>(count));
    std::iota(corners.begin(), corners.end(), 0);
    EXPECT_EQ(With(corners).mesh.triangles.size(), static_cast<size_t>(count - 2));
    corners.back() = 1;
    EXPECT_THAT(With(corners).mesh.triangles, IsEmpty()) << count;
    EXPECT_EQ(With(corners).polygon_count, 1);
  }
}

TEST(AddPolygonTest, ACornerThatRepeatsTheOneBeforeDoesNotCount) {
  EXPECT_THAT(With({4, 5, 5, 6}).mesh.triangles, ElementsAre(Triangle{4, 5, 6}));
  EXPECT_THAT(With({4, 5, 6, 4}).mesh.triangles, ElementsAre(Triangle{4, 5, 6}));
  EXPECT_THAT(With({9, 1, 2, 2, 2, 3}).mesh.triangles, ElementsAre(Triangle{9, 1, 2}, Triangle{9, 2, 3}));
  EXPECT_THAT(With({4, 4, 5, 5}).mesh.triangles, IsEmpty());
}

TEST(CheckPatchTest, TakesWhatFits) {
  EXPECT_TRUE(CheckPatch({}, 0, "a").ok());
  EXPECT_TRUE(CheckPatch({{{1, 2, 3}, {1e9, -1e9, 0}}, {2, -1}, {{0, 3, 4}}}, 3, "a").ok());
}

TEST(CheckPatchTest, SaysWhatDoesNot) {
  const auto message = [](const FilePatch& patch) {
    const absl::Status status = CheckPatch(patch, 3, "a.obj");
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), HasSubstr("a.obj: bad patch: "));
    return std::string(status.message());
  };
  EXPECT_THAT(message({{{0, 0, 0}}, {}, {}}), HasSubstr("1 new points but 0 models"));
  EXPECT_THAT(message({{{0, 0, 0}}, {3}, {}}), HasSubstr("no vertex 3 to be like"));
  EXPECT_THAT(message({{{0, 0, 0}}, {-2}, {}}), HasSubstr("no vertex -2 to be like"));
  EXPECT_THAT(message({{{0, std::nan(""), 0}}, {0}, {}}), HasSubstr("coordinate nan"));
  EXPECT_THAT(message({{{0, 0, 1.1e9}}, {0}, {}}), HasSubstr("coordinate 1.1e+09"));
  EXPECT_THAT(message({{{0, 0, 0}}, {0}, {{0, 1, 4}}}), HasSubstr("no vertex 4"));
  EXPECT_THAT(message({{}, {}, {{-1, 1, 2}}}), HasSubstr("no vertex -1"));
  EXPECT_THAT(std::string(CheckPatch({{{0, 0, 0}}, {0}, {}}, 0x7fffffff, "a").message()), HasSubstr("are too many"));
}

}  // namespace
}  // namespace tilemend
