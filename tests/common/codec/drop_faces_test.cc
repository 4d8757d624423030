#include "common/codec/drop_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

std::string Without(MeshFormat format, const std::string& bytes, const std::vector<bool>& drop) {
  const auto out = DropFaces(format, bytes, drop, "a mesh");
  EXPECT_TRUE(out.ok()) << out.status();
  return out.ok() ? *out : "";
}

constexpr char kObj[] =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nusemtl x\nf 1/1 2/1 3/1\n# mine\nusemtl y\n"
    "  f 1/1 3/1 \\\n  4/1 # the second\nf -4 -3 -2\n";

TEST(DropFacesTest, DropsLinesOfObjAndNothingElse) {
  EXPECT_EQ(Without(MeshFormat::kObj, kObj, {false, false, false}), kObj);
  EXPECT_EQ(Without(MeshFormat::kObj, kObj, {true, false, false}),
            absl::StrReplaceAll(kObj, {{"f 1/1 2/1 3/1\n", ""}}));
  EXPECT_EQ(Without(MeshFormat::kObj, kObj, {false, true, false}),
            absl::StrReplaceAll(kObj, {{"  f 1/1 3/1 \\\n  4/1 # the second\n", ""}}));
  EXPECT_EQ(Without(MeshFormat::kObj, kObj, {false, false, true}), absl::StrReplaceAll(kObj, {{"f -4 -3 -2\n", ""}}));
}

TEST(DropFacesTest, LinesOfObjMayEndInAnyWay) {
  for (const char* eol : {"\r\n", "\r"}) {
    const std::string obj = absl::StrReplaceAll("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1", {{"\n", eol}});
    EXPECT_EQ(Without(MeshFormat::kObj, obj, {true, false}),
              absl::StrReplaceAll(obj, {{absl::StrCat("f 1 2 3", eol), ""}}));
    EXPECT_EQ(Without(MeshFormat::kObj, obj, {false, true}), obj.substr(0, obj.size() - 7));
  }
}

TEST(DropFacesTest, AFaceGoesOnlyWithAllOfItsTriangles) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  EXPECT_EQ(Without(MeshFormat::kObj, obj, {true, false}), obj);
  EXPECT_EQ(Without(MeshFormat::kObj, obj, {true, true}), obj.substr(0, obj.size() - 10));
}

TEST(DropFacesTest, AnObjWithoutFacesIsRefusedUnlessItIsAskedFor) {
  const std::string left = Without(MeshFormat::kObj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", {true});
  EXPECT_EQ(left, "v 0 0 0\nv 1 0 0\nv 1 1 0\n");
  EXPECT_FALSE(ParseMesh(MeshFormat::kObj, left, "a mesh").ok());
  EXPECT_TRUE(ParseMesh(MeshFormat::kObj, left, "a mesh", NoFaces::kAccept).ok());
  FilePatch patch;
  patch.triangles = {{0, 1, 2}};
  EXPECT_TRUE(AppendPatch(MeshFormat::kObj, left, patch, "a mesh").ok());
}

std::string PlyHeaderOf(const std::string& format, int faces) {
  return absl::StrCat(
      "ply\nformat ", format, " 1.0\ncomment mine\nelement vertex 4\nproperty float x\nproperty float y\n",
      "property float z\nelement face ", faces,
      "\nproperty uchar flags\nproperty list uchar int vertex_indices\nelement edge 1\nproperty uchar q\n"
      "end_header\n");
}

TEST(DropFacesTest, DropsLinesOfTextPlyAndCountsFacesAgain) {
  const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const auto file = [&](int faces, const std::string& lines) {
    return absl::StrCat(PlyHeaderOf("ascii", faces), vertices, lines, "9\n");
  };
  const std::string all = file(3, "5 3 0 1 2\n6 4 0 1 2 3\n7 3 0 2 3\n");
  EXPECT_EQ(Without(MeshFormat::kPly, all, {true, false, false, false}), file(2, "6 4 0 1 2 3\n7 3 0 2 3\n"));
  EXPECT_EQ(Without(MeshFormat::kPly, all, {false, true, true, true}), file(1, "5 3 0 1 2\n"));
  EXPECT_EQ(Without(MeshFormat::kPly, all, {false, true, false, false}), all);
  EXPECT_EQ(Without(MeshFormat::kPly, all, {true, true, true, true}), file(0, ""));
}

std::string Face(char flags, std::vector<int32_t> corners) {
  std::string record = {flags, static_cast<char>(corners.size())};
  for (const int32_t c : corners) record.append(reinterpret_cast<const char*>(&c), sizeof(c));
  return record;
}

TEST(DropFacesTest, DropsRecordsOfBinaryPlyAndCountsFacesAgain) {
  std::string vertices;
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) {
    vertices.append(reinterpret_cast<const char*>(&x), sizeof(x));
  }
  const auto file = [&](int faces, const std::string& records) {
    return absl::StrCat(PlyHeaderOf("binary_little_endian", faces), vertices, records, "q");
  };
  const std::string a = Face('a', {0, 1, 2}), b = Face('b', {0, 2, 3}), quad = Face('c', {0, 1, 2, 3});
  EXPECT_EQ(Without(MeshFormat::kPly, file(2, a + b), {false, true}), file(1, a));
  EXPECT_EQ(Without(MeshFormat::kPly, file(3, a + quad + b), {true, true, true, false}), file(1, b));
  EXPECT_EQ(Without(MeshFormat::kPly, file(3, a + quad + b), {false, false, false, true}), file(2, a + quad));
  EXPECT_EQ(Without(MeshFormat::kPly, file(2, a + b), {true, true}), file(0, ""));
}

TEST(DropFacesTest, OtherFormatsAreRefusedInWords) {
  const auto out = DropFaces(MeshFormat::kOff, "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n", {true}, "a.off");
  EXPECT_TRUE(absl::IsInvalidArgument(out.status()));
  EXPECT_THAT(std::string(out.status().message()), HasSubstr("a.off: surface can be taken out"));
}

}  // namespace
}  // namespace tilemend
