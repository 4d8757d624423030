#include "common/codec/ply_colours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/codec/mesh_file.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(PlyVertexColoursTest, ReadsTextWithListsBetween) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty uchar green\nproperty list uchar int l\n"
      "property float y\nproperty float z\nproperty uchar red\nproperty uchar blue\n" +
      kFaces + "0 2 1 9 0 0 1 3\n1 20 0 0 0 10 30\n0 21 2 7 7\n1 0 11 31\n3 0 1 2\n";
  const auto colours = PlyVertexColours(text, {2, 0}, "a.ply");
  ASSERT_TRUE(colours.ok()) << colours.status();
  EXPECT_THAT(*colours, ElementsAre(Rgb{11, 21, 31}, Rgb{1, 2, 3}));
}

TEST(PlyVertexColoursTest, ReadsBinaryAlsoBehindOtherElements) {
  const FilePatch patch = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}}, {{1, 2, 3}, {4, 5, 6}, {7, 8, 250}}};
  std::string bytes = NewPlyFile(patch, NumberType::kFloat64);
  EXPECT_THAT(*PlyVertexColours(bytes, {0, 2}, "a.ply"), ElementsAre(Rgb{1, 2, 3}, Rgb{7, 8, 250}));
  bytes.insert(bytes.find("element vertex"), "element other 1\nproperty list uchar uchar l\n");
  bytes.insert(bytes.find("end_header\n") + 11, "\2ab");
  EXPECT_THAT(*PlyVertexColours(bytes, {0, 2}, "a.ply"), ElementsAre(Rgb{1, 2, 3}, Rgb{7, 8, 250}));
}

TEST(PlyVertexColoursTest, FilesWithoutColoursHaveNone) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_THAT(*PlyVertexColours(start + kFaces + body, {0, 1}, "a.ply"), IsEmpty());
  const std::string wide = "0 0 0 1 1 1\n1 0 0 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n";
  EXPECT_THAT(
      *PlyVertexColours(start + "property float red\nproperty float green\nproperty float blue\n" + kFaces + wide, {0},
                        "a.ply"),
      IsEmpty());
}

TEST(PlyFaceColoursTest, EveryTriangleHasTheColourOfItsFace) {
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty uchar red\nproperty list uchar int vertex_indices\nproperty uchar blue\n"
      "property uchar green\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto colours = PlyFaceColours(start + "1 3 0 1 2 3 2\n9 2 0 1 9 9\n4 4 0 1 2 3\n6 5\n7 3 0 2 3 9 8\n", "a.ply");
  ASSERT_TRUE(colours.ok()) << colours.status();
  EXPECT_THAT(*colours, ElementsAre(Rgb{1, 2, 3}, Rgb{4, 5, 6}, Rgb{4, 5, 6}, Rgb{7, 8, 9}));
}

TEST(PlyFaceColoursTest, ReadsBinaryAndLeavesFilesWithoutAlone) {
  const FilePatch patch = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}, {0, 2, 1}}};
  std::string bytes = NewPlyFile(patch, NumberType::kFloat32, FaceMark::kNone);
  EXPECT_THAT(*PlyFaceColours(bytes, "a.ply"), IsEmpty());
  constexpr size_t kFace = 13;
  bytes.insert(bytes.size() - kFace, "\1\2\3");
  bytes += "\4\5\6";
  bytes.insert(bytes.find("end_header"), "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  EXPECT_THAT(*PlyFaceColours(bytes, "a.ply"), ElementsAre(Rgb{1, 2, 3}, Rgb{4, 5, 6}));
}

TEST(PlyTextureNamesTest, GivesEachNameOfTheHeaderOnce) {
  EXPECT_THAT(PlyTextureNames("ply\r\ncomment TextureFile a b.png \r\ncomment TextureFile c.jpg\r\ncomment TextureFile "
                              "c.jpg\ncomment by hand\nend_header\ncomment TextureFile d.jpg\n"),
              ElementsAre("a b.png", "c.jpg"));
  EXPECT_THAT(PlyTextureNames("comment TextureFile  \n"), IsEmpty());
}

}  // namespace
}  // namespace tilemend
