// Appending to PLY files, and new ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "common/codec/mesh_file.h"
#include "common/codec/ply.h"
#include "tests/common/codec/odd_ply.h"

namespace tilemend {
namespace {

using testing::Bytes;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::Join;
using testing::kAsciiHeader;
using testing::OddPly;
using testing::Parse;

class PlyAppendTest : public ::testing::TestWithParam<std::tuple<bool, std::string>> {};

TEST_P(PlyAppendTest, KeepsEveryOriginalRecordByteForByte) {
  OddPly odd = {.big_endian = std::get<0>(GetParam()), .eol = std::get<1>(GetParam())};
  const std::string before = odd.Header() + Join(odd.Vertices()) + Join(odd.Faces()) + odd.Edges();
  const FilePatch patch = {.new_points = {{5, 6, 0.7}, {8, 9, 10}}, .like = {1, -1}, .triangles = {{3, 4, 5}}};
  const auto after = AppendPatch(MeshFormat::kPly, before, patch, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  const std::string zero(1, '\0');
  odd.vertex_count = "6";
  odd.face_count = "4";
  odd.filled_property = "property uchar tilemend_filled|";
  const std::string expected = odd.Header() + Join(odd.Vertices()) + odd.Vertex(2, 5, 6, {7, -8}, 0.7) +
                               odd.Vertex(0, 8, 9, {}, 10) + Join(odd.Faces(), zero) + odd.Face(0, {3, 4, 5}, {}) +
                               '\1' + odd.Edges();
  EXPECT_EQ(*after, expected);
  // A second patch keeps the marks of the first and adds no second property.
  const auto again = AppendPatch(MeshFormat::kPly, *after, {{}, {}, {{0, 1, 3}}}, "a.ply");
  ASSERT_TRUE(again.ok()) << again.status();
  odd.face_count = "5";
  EXPECT_EQ(*again, odd.Header() + Join(odd.Vertices()) + odd.Vertex(2, 5, 6, {7, -8}, 0.7) +
                        odd.Vertex(0, 8, 9, {}, 10) + Join(odd.Faces(), zero) + odd.Face(0, {3, 4, 5}, {}) + '\1' +
                        odd.Face(0, {0, 1, 3}, {}) + '\1' + odd.Edges());
}

INSTANTIATE_TEST_SUITE_P(EncodingsAndLineEndings, PlyAppendTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Values("\n", "\r\n", "\r")));

TEST(PlyAppendTextTest, AppendsBehindOriginalText) {
  const std::string before = std::string(kAsciiHeader) + "0.10 0 0  7\n1e0 0 0 8\r\n0\t1 0 9\n3 0 1 2\n2 5 6\n";
  const auto after =
      AppendPatch(MeshFormat::kPly, before, {{{0.1, 1.0 / 3, 2}, {1, 2, 3}}, {1, -1}, {{2, 3, 4}}}, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_THAT(*after, HasSubstr("element vertex 5\n"));
  EXPECT_THAT(*after, HasSubstr("vertex_indices\nproperty uchar tilemend_filled\nelement note"));
  EXPECT_THAT(*after, EndsWith("end_header\n0.10 0 0  7\n1e0 0 0 8\r\n0\t1 0 9\n0.1 0.3333333333333333 2 8\n1 2 3 0\n"
                               "3 0 1 2 0\n3 2 3 4 1\n2 5 6\n"));
}

TEST(PlyAppendTextTest, AppendsFirstFaceToFileWithoutAny) {
  const std::string header = "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\n";
  const std::string before = header +
                             "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  const auto after = AppendPatch(MeshFormat::kPly, before, {{}, {}, {{0, 1, 2}}}, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_THAT(*after, EndsWith("end_header\n3 0 1 2 1\n0 0 0\n1 0 0\n0 1 0\n"));
}

TEST(PlyAppendBinaryTest, NewFileReadsBackRoundedToItsNumberType) {
  const FilePatch patch = {{{0.1, 0.2, 0.3}, {1, 0, 0}, {0, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}}};
  const auto narrow = Parse(NewPlyFile(patch, NumberType::kFloat32));
  const auto wide = Parse(NewPlyFile(patch, NumberType::kFloat64));
  ASSERT_TRUE(narrow.ok() && wide.ok());
  EXPECT_EQ(narrow->number_type, NumberType::kFloat32);
  EXPECT_EQ(narrow->mesh.points[0], Point3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(wide->number_type, NumberType::kFloat64);
  EXPECT_EQ(wide->mesh.points[0], Point3(0.1, 0.2, 0.3));
  EXPECT_EQ(narrow->mesh.triangles, patch.triangles);
}

// `marks` is what each face has behind its corners.
std::string FloatTriangles(const std::string& face_properties, const std::vector<std::string>& marks) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face " +
      std::to_string(marks.size()) + "\nproperty list uchar int vertex_indices\n" + face_properties + "end_header\n";
  for (int i = 0; i < 12; ++i) bytes += Bytes(static_cast<float>(i), false);
  int32_t corner = 0;
  for (const std::string& mark : marks) {
    bytes += '\3';
    for (int k = 0; k < 3; ++k) bytes += Bytes(corner++ % 4, false);
    bytes += mark;
  }
  return bytes;
}

TEST(PlyAppendBinaryTest, CopiesTrianglesOfOneSize) {
  const FilePatch patch = {{}, {}, {{2, 3, 0}}};  // the corners that come next
  const std::string filled = "property uchar tilemend_filled\n", zero(1, '\0');
  const auto append = [&](const std::string& before) {
    return AppendPatch(MeshFormat::kPly, before, patch, "a.ply").value();
  };
  const std::string once = append(FloatTriangles("", {"", ""}));
  EXPECT_EQ(once, FloatTriangles(filled, {zero, zero, "\1"}));
  EXPECT_EQ(append(FloatTriangles(filled, {"\1", zero})), FloatTriangles(filled, {"\1", zero, "\1"}))
      << "what is marked already stays so";
  EXPECT_EQ(append(FloatTriangles("property short kind\n", {"ab", "cd"})),
            FloatTriangles("property short kind\n" + filled, {"ab" + zero, "cd" + zero, zero + zero + "\1"}));
}

TEST(PlyAppendBinaryTest, FacesOfEverySizeGiveTheirPropertiesToWhatIsCutFromThem) {
  const std::string filled = "property uchar tilemend_filled\n", zero(1, '\0');
  FilePatch patch = {{}, {}, {{2, 3, 0}}};
  patch.cut_from = {1};
  EXPECT_EQ(
      AppendPatch(MeshFormat::kPly, FloatTriangles("property short kind\n", {"ab", "cd"}), patch, "a.ply").value(),
      FloatTriangles("property short kind\n" + filled, {"ab" + zero, "cd" + zero, "cd\1"}));
  for (const bool big : {false, true}) {
    OddPly odd = {.big_endian = big};
    const std::string before = odd.Header() + Join(odd.Vertices()) + Join(odd.Faces()) + odd.Edges();
    FilePatch half = {{}, {}, {{0, 1, 3}}};
    half.cut_from = {3};  // the triangle behind the quad
    odd.face_count = "4";
    odd.filled_property = "property uchar tilemend_filled|";
    EXPECT_EQ(AppendPatch(MeshFormat::kPly, before, half, "a.ply").value(),
              odd.Header() + Join(odd.Vertices()) + Join(odd.Faces(), zero) + odd.Face(7, {0, 1, 3}, {0.25F}) + '\1' +
                  odd.Edges());
  }
}

TEST(PlyAppendBinaryTest, WidensIndicesThatDoNotFit) {
  std::string before =
      "ply\nformat binary_little_endian 1.0\nelement vertex 255\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (int i = 0; i < 255 * 3; ++i) before += Bytes(static_cast<float>(i), false);
  before += std::string("\3\0\1\2", 4) + "\3\xfe\1\2";
  const FilePatch patch = {{{0, 0, 0}, {1, 1, 1}}, {0, 0}, {{254, 255, 256}}};
  const auto after = AppendPatch(MeshFormat::kPly, before, patch, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  const auto file = Parse(*after);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{254, 1, 2}, Triangle{254, 255, 256}));
  EXPECT_THAT(*after, HasSubstr("property list uchar int vertex_indices\nproperty uchar tilemend_filled\n"));
}

TEST(PlyAppendBinaryTest, WidensIndicesOfEverySmallTypeAmongOtherProperties) {
  for (const std::string type : {"char", "short", "ushort"}) {
    const int vertices = type == "char" ? 128 : type == "short" ? 32768 : 65536;
    for (const bool big : {false, true}) {
      std::string before = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                           "_endian 1.0\nelement vertex " + std::to_string(vertices) +
                           "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                           "property list uchar short spare\nproperty list uchar " +
                           type + " vertex_indices\nproperty double area\nend_header\n";
      for (int i = 0; i < 3 * vertices; ++i) before += Bytes(static_cast<float>(i), big);
      before += std::string("\1", 1) + Bytes(int16_t{-3}, big) + "\3";
      for (const int corner : {2, 1, 0}) {
        before += type == "char" ? std::string(1, static_cast<char>(corner)) : Bytes(static_cast<int16_t>(corner), big);
      }
      before += Bytes(0.5, big);
      const auto after = AppendPatch(MeshFormat::kPly, before, {{{1, 2, 3}}, {-1}, {{0, 1, vertices}}}, "a.ply");
      ASSERT_TRUE(after.ok()) << after.status();
      const auto file = Parse(*after);
      ASSERT_TRUE(file.ok()) << file.status();
      EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{2, 1, 0}, Triangle{0, 1, vertices})) << type;
      EXPECT_THAT(*after, HasSubstr(Bytes(int16_t{-3}, big) + "\3" + Bytes(int32_t{2}, big))) << type;
    }
  }
}

TEST(PlyAppendTextTest, CopiesTheListsOfTheVertexThatANewOneIsLike) {
  const std::string before =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int seen\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 1 2 3 10\n2 -7 8 4 5 6 20\n1 9 7 8 9 30\n3 0 1 2\n";
  const auto after = AppendPatch(MeshFormat::kPly, before, {{{0, 0, 1}, {0, 0, 2}}, {1, -1}, {}}, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_THAT(*after, HasSubstr("1 9 7 8 9 30\n2 -7 8 0 0 1 20\n0 0 0 2 0\n3 0 1 2 0\n"));
}

TEST(PlyAppendTextTest, PutsTheColoursOfThePatchInPlaceOfThoseOfLikes) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty uchar red\nproperty float x\nproperty float y\n"
      "property uchar green\nproperty float z\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::string text = header + "1 0 0 2 0 3 4\n5 1 0 6 0 7 8\n9 0 1 10 0 11 12\n3 0 1 2\n";
  const FilePatch patch = {{{2, 2, 2}, {3, 3, 3}}, {1, -1}, {{0, 1, 3}}, {{20, 21, 22}, {30, 31, 32}}};
  const auto out = AppendPatch(MeshFormat::kPly, text, patch, "a.ply");
  ASSERT_TRUE(out.ok()) << out.status();
  EXPECT_THAT(*out, ::testing::HasSubstr("\n20 2 2 21 2 22 8\n30 3 3 31 3 32 255\n3 0 1 2 0\n"))
      << "what is like nothing in the file is opaque";
}

// Faces of every encoding with a colour, an opacity and a list.
std::string ColouredFaces(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
         "property uchar red\nproperty list uchar short tags\nproperty uchar green\n"
         "property list uchar int vertex_indices\nproperty uchar blue\nproperty uchar alpha\nend_header\n";
}

const std::string kFourPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(PlyAppendTextTest, NewFacesHaveTheColoursOfTheirRunsAndAreOpaque) {
  const std::string text = ColouredFaces("ascii") + kFourPoints + "1 0 2 3 0 1 2 3 4\n5 1 -9 6 3 0 2 3 7 8\n";
  FilePatch patch = {{}, {}, {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}}};
  patch.materials = {{0, "a", Rgb{10, 20, 30}}, {2, "b", Rgb{40, 50, 60}}};
  const auto out = AppendPatch(MeshFormat::kPly, text, patch, "a.ply");
  ASSERT_TRUE(out.ok()) << out.status();
  EXPECT_THAT(*out, EndsWith("\n5 1 -9 6 3 0 2 3 7 8 0\n10 0 20 3 0 1 3 30 255 1\n10 0 20 3 1 2 3 30 255 1\n"
                             "40 0 50 3 0 2 1 60 255 1\n"));
}

TEST(PlyAppendTextTest, WhatIsCutFromAFaceHasItsProperties) {
  const std::string text = ColouredFaces("ascii") + kFourPoints + "1 0 2 3 0 1 2 3 4\n5 1 -9 6 3 0 2 3 7 8\n";
  FilePatch patch = {{}, {}, {{0, 1, 3}, {1, 2, 3}}};
  patch.cut_from = {1, 0};
  const auto out = AppendPatch(MeshFormat::kPly, text, patch, "a.ply");
  ASSERT_TRUE(out.ok()) << out.status();
  EXPECT_THAT(*out, EndsWith("\n5 1 -9 6 3 0 2 3 7 8 0\n5 1 -9 6 3 0 1 3 7 8 1\n1 0 2 3 1 2 3 3 4 1\n"));
  // Where there are marks already, it has one as well.
  FilePatch again = {{}, {}, {{1, 2, 3}}};
  again.cut_from = {0};
  EXPECT_THAT(AppendPatch(MeshFormat::kPly, *out, again, "a.ply").value(), EndsWith(" 1\n1 0 2 3 1 2 3 3 4 1\n"));
  patch.cut_from = {1};
  EXPECT_THAT(std::string(AppendPatch(MeshFormat::kPly, text, patch, "a.ply").status().message()),
              HasSubstr("2 triangles but 1 that they were cut from"));
  patch.cut_from = {1, 2};
  EXPECT_THAT(std::string(AppendPatch(MeshFormat::kPly, text, patch, "a.ply").status().message()),
              HasSubstr("no triangle 2 to be cut from"));
}

TEST(PlyAppendTextTest, RefusesABadPatch) {
  const std::string file = std::string(kAsciiHeader) + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n0\n";
  const auto message = [&file](const FilePatch& patch) {
    return std::string(AppendPatch(MeshFormat::kPly, file, patch, "a.ply").status().message());
  };
  EXPECT_THAT(message({{{0, 0, 0}}, {}, {}}), HasSubstr("1 new points but 0 models"));
  EXPECT_THAT(message({{{0, 0, 0}}, {3}, {}}), HasSubstr("no vertex 3 to be like"));
  EXPECT_THAT(message({{}, {}, {{0, 1, 3}}}), HasSubstr("no vertex 3"));
  EXPECT_THAT(message({{}, {}, {{0, 1, -1}}}), HasSubstr("no vertex -1"));
  EXPECT_THAT(message({{{0, 0, std::nan("")}}, {0}, {}}), HasSubstr("coordinate nan"));
}

}  // namespace
}  // namespace tilemend
