#include "common/assemble/clear_tile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/str_replace.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

const PlanePolygon kLeft{{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}}, kRight{{{{4, 0}, {6, 0}, {6, 1}, {4, 1}}}};
// Three squares of 1 m in a row with gaps between them; the last one is a face with four corners.
constexpr char kTile[] =
    "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 4 0 3\nv 5 0 3\nv 5 1 3\nv 4 1 9\n# faces\nf 1 2 3\nf 1 3 4\nf 5 6 7 8\n";

TEST(ClearTileTest, CountsWhatEachAreaTakes) {
  const auto cleared = ClearTile(MeshFormat::kObj, kTile, std::vector<ClearArea>{{kRight, 10}, {kLeft, 2}}, "a.obj");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  EXPECT_THAT(cleared->triangles, ElementsAre(2, 2));
  EXPECT_THAT(cleared->file.mesh.triangles, SizeIs(0));
  EXPECT_THAT(cleared->file.mesh.points, SizeIs(8)) << "vertices stay";
  EXPECT_EQ(cleared->bytes, absl::StrReplaceAll(kTile, {{"f 1 2 3\n", ""}, {"f 1 3 4\n", ""}, {"f 5 6 7 8\n", ""}}));
}

TEST(ClearTileTest, AFaceStaysWhereOneOfItsTrianglesDoes) {
  const auto cleared = ClearTile(MeshFormat::kObj, kTile, std::vector<ClearArea>{{kRight, 5}}, "a.obj");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  EXPECT_THAT(cleared->triangles, ElementsAre(0));
  EXPECT_THAT(cleared->file.mesh.triangles, SizeIs(4));
  EXPECT_EQ(cleared->bytes, kTile);
}

TEST(ClearTileTest, TheMeshIsThatOfTheBytes) {
  const auto cleared = ClearTile(MeshFormat::kObj, kTile, std::vector<ClearArea>{{kLeft, 2}}, "a.obj");
  ASSERT_TRUE(cleared.ok()) << cleared.status();
  const auto again = ParseMesh(MeshFormat::kObj, cleared->bytes, "a.obj");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->mesh.triangles, cleared->file.mesh.triangles);
}

}  // namespace
}  // namespace tilemend
