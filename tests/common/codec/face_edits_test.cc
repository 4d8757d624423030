#include "common/codec/face_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "absl/strings/str_replace.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

std::string Changed(MeshFormat format, const std::string& bytes, const std::vector<TriangleChange>& changes) {
  const auto out = ChangeTriangles(format, bytes, changes, "a mesh");
  EXPECT_TRUE(out.ok()) << out.status();
  return out.ok() ? *out : "";
}

TEST(ChangeTrianglesTest, ChangesNumbersOfOffAndNothingElse) {
  const std::string off = "OFF # mine\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1 1 1e-3\n3 0 1 2 255 0 0\n 3  +0 2\t3\n";
  EXPECT_EQ(Changed(MeshFormat::kOff, off, {{1, {0, 2, 3}, {0, 4, 3}}}),
            absl::StrReplaceAll(off, {{"+0 2\t3", "+0 4\t3"}}));
  EXPECT_EQ(Changed(MeshFormat::kOff, off, {}), off);
}

TEST(ChangeTrianglesTest, ChangesVerticesOfObjAndNoTextureCoordinates) {
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvt 1 1\nf 1/1 2/2 3/1\nusemtl x\nf -5/1/ -3/2 -2//\n";
  EXPECT_EQ(Changed(MeshFormat::kObj, obj, {{0, {0, 1, 2}, {0, 1, 4}}, {1, {0, 2, 3}, {0, 4, 3}}}),
            absl::StrReplaceAll(obj, {{"3/1\n", "5/1\n"}, {"-3/2", "5/2"}}));
}

TEST(ChangeTrianglesTest, ChangesACornerOfAPolygonOnce) {
  const std::string off = "OFF\n6 1 0\n0 0 0\n1 0 0\n2 1 0\n1 2 0\n0 1 0\n9 9 9\n5 0 1 2 3 4\n";
  // Corner 2 is one of two triangles of the fan.
  EXPECT_EQ(Changed(MeshFormat::kOff, off, {{0, {0, 1, 2}, {0, 1, 5}}, {1, {0, 2, 3}, {0, 5, 3}}}),
            absl::StrReplaceAll(off, {{"5 0 1 2 3 4", "5 0 1 5 3 4"}}));
}

TEST(ChangeTrianglesTest, ChangesACornerOfAConcavePolygon) {
  // A fan around corner 0 would turn over.
  const std::string off = "OFF\n6 1 0\n0 0 0\n3 -1 0\n1 0 0\n3 1 0\n0 4 0\n9 9 9\n5 0 1 2 3 4\n";
  const auto faces = ParseFaces(MeshFormat::kOff, off, "a mesh");
  ASSERT_TRUE(faces.ok()) << faces.status();
  EXPECT_EQ(faces->face_of, std::vector<int32_t>(3, 0));
  std::vector<TriangleChange> changes;
  for (int32_t t = 0; t < 3; ++t) {
    const Triangle from = faces->file.mesh.triangles[static_cast<size_t>(t)];
    TriangleChange change{t, from, from};
    for (int32_t& v : change.to) v = v == 3 ? 5 : v;
    changes.push_back(change);
  }
  EXPECT_EQ(Changed(MeshFormat::kOff, off, changes), absl::StrReplaceAll(off, {{"5 0 1 2 3 4", "5 0 1 2 5 4"}}));
}

std::string PlyHeaderOf(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
         "property uchar flag\nproperty list uchar ushort vertex_indices\nend_header\n";
}

TEST(ChangeTrianglesTest, ChangesTextAndBinaryPly) {
  const std::string text = PlyHeaderOf("ascii") + "0 0 0\n1 0 0\n0 1 0\n0 1 1\n7 3 0 1 2\n";
  EXPECT_EQ(Changed(MeshFormat::kPly, text, {{0, {0, 1, 2}, {0, 1, 3}}}),
            absl::StrReplaceAll(text, {{"7 3 0 1 2", "7 3 0 1 3"}}));
  for (const bool big : {false, true}) {
    std::string bytes = PlyHeaderOf(big ? "binary_big_endian" : "binary_little_endian") + std::string(48, '\0');
    bytes += std::string("\7\3", 2);
    const size_t corners = bytes.size();
    const auto corner = [&](int k) { return corners + static_cast<size_t>(2 * k + (big ? 1 : 0)); };
    bytes += std::string(6, '\0');
    bytes[corner(1)] = 1;
    bytes[corner(2)] = 2;
    std::string expected = bytes;
    expected[corner(2)] = 3;
    EXPECT_EQ(Changed(MeshFormat::kPly, bytes, {{0, {0, 1, 2}, {0, 1, 3}}}), expected) << big;
  }
}

TEST(ChangeTrianglesTest, CopiesCoordinatesInStl) {
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\n vertex " + c + "\nendloop\nendfacet\n";
  };
  const std::string first = facet("0 0 0", "1 0 0", "1 1 0");
  const std::string text = "solid s\n" + first + facet("0 0 0", "1.0  1e-9 0", "2 0 0") + "endsolid s\n";
  EXPECT_EQ(Changed(MeshFormat::kStl, text, {{1, {3, 4, 5}, {3, 1, 5}}}),
            "solid s\n" + first + facet("0 0 0", "1 0 0", "2 0 0") + "endsolid s\n");
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  const float corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0};
  std::memcpy(&binary[96], corners, sizeof(corners));
  std::string expected = binary;
  std::memcpy(&expected[96 + 24], corners + 3, 12);
  EXPECT_EQ(Changed(MeshFormat::kStl, binary, {{0, {0, 1, 2}, {0, 1, 1}}}), expected);
}

TEST(ParseFacesTest, TellsWhichTrianglesAreOneFaceAndWhatHasTextures) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\n";
  const auto plain = ParseFaces(MeshFormat::kObj, vertices + "f 1 2 3 4\nf 1 1 2\nf 1//1 2//1 3//1\n", "a.obj");
  ASSERT_TRUE(plain.ok()) << plain.status();
  EXPECT_THAT(plain->face_of, ElementsAre(0, 0, 1));
  EXPECT_FALSE(plain->has_textures);
  const auto textured = ParseFaces(MeshFormat::kObj, vertices + "f 1/1 2/1 3/1\n", "a.obj");
  ASSERT_TRUE(textured.ok());
  EXPECT_TRUE(textured->has_textures);
  const std::string ply = PlyHeaderOf("ascii"), body = "0 0 0\n1 0 0\n0 1 0\n0 1 1\n7 3 0 1 2";
  EXPECT_FALSE(ParseFaces(MeshFormat::kPly, ply + body + "\n", "a.ply").value().has_textures);
  const std::string places =
      absl::StrReplaceAll(ply, {{"end_header", "property list uchar float texcoord\nend_header"}});
  EXPECT_TRUE(ParseFaces(MeshFormat::kPly, places + body + " 6 0 0 1 0 0 1\n", "a.ply").value().has_textures);
}

}  // namespace
}  // namespace tilemend
