#include "common/codec/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "common/codec/mesh_file.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

absl::StatusOr<MeshFile> Parse(const std::string& text) { return ParseMesh(MeshFormat::kObj, text, "a.obj"); }

std::string MessageOf(const std::string& text) {
  const absl::StatusOr<MeshFile> file = Parse(text);
  EXPECT_EQ(file.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(file.status().message());
}

std::string Appended(const std::string& text, const FilePatch& patch) {
  const absl::StatusOr<std::string> out = AppendPatch(MeshFormat::kObj, text, patch, "a.obj");
  EXPECT_TRUE(out.ok()) << out.status();
  return out.value_or("");
}

const FilePatch kPatch = {{{0.1, -1.0 / 3, 1e-7}}, {0}, {{0, 2, 3}}, {}, {{0, "grey"}}};

TEST(ObjTest, ReadsEveryFormOfCorner) {
  const auto file = Parse(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\n"
      "f 1/1/1 2/1/1 3/1/1\nf -3 -2/-1 -1//-1\nf 1/1/ 2/1/ 3\n");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat64);
  EXPECT_THAT(file->mesh.triangles, ::testing::AllOf(::testing::SizeIs(6), ::testing::Each(Triangle{0, 1, 2})));
}

TEST(ObjTest, ReadsNumbersToTheLastBit) {
  const auto file = Parse("v 0.1 +.5 1e-3\nv 123456.0009765625 -0 5. 0.5 nan 1\nv 1 2 3 1.0\nf 1 2 3");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.points,
              ElementsAre(Point3(0.1, 0.5, 1e-3), Point3(123456.0009765625, -0.0, 5), Point3(1, 2, 3)));
}

TEST(ObjTest, FansPolygonsAndSkipsFacesWithoutSurface) {
  const auto file = Parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2\nf 1 2 1\nf 1 2 3 1\n");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 1, 2}));
  EXPECT_EQ(file->polygon_count, 2);
}

TEST(ObjTest, CutsAPolygonThatStandsBeforeItsVertices) {
  const std::string vertices = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\n", face = "f 1/1 2/2 3/3 4/4\n";  // an arrowhead
  const auto usual = Parse(vertices + face);
  ASSERT_TRUE(usual.ok()) << usual.status();
  for (const Triangle& t : usual->mesh.triangles) EXPECT_THAT(t, ::testing::Not(::testing::IsSupersetOf({0, 2})));
  for (const std::string& text : {face + vertices, "v 0 0 0\n" + face + "v 4 0 0\nv 4 4 0\nv 3 1 0\n"}) {
    const auto file = Parse(text);
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(file->mesh.triangles, usual->mesh.triangles);
    EXPECT_EQ(file->mesh.points, usual->mesh.points);
    const auto textured = ParseTexturedObj(text, "a.obj");
    ASSERT_TRUE(textured.ok()) << textured.status();
    EXPECT_EQ(textured->textures.corners.size(), 2U);
  }
  EXPECT_THAT(MessageOf("f 1 2 3 4\nv 0 0 0\nv 1 0 0\n"), HasSubstr("line 1: expected a vertex index of at most 2"));
  EXPECT_THAT(MessageOf("f 1 2 3 4\n"), HasSubstr("no vertices"));
}

TEST(ObjTest, JoinsContinuedLinesButNotComments) {
  const auto file =
      Parse("# C:\\models\\\nv 0 0 \\\n 0\nv 1 0 0 # here \\\r\nv 0 1 0\r\ng a \\\r\n f 9 9 9\nf 1 \\\r\n2 3");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->mesh.points.size(), 3u);
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjTest, ReadsVerticesThatComeAfterTheirFace) {
  const auto file = Parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

TEST(ObjTest, KeepsEveryByteAndAppends) {
  const std::string text =
      "# c\nmtllib m.mtl\ncurv2 1 2\nl 1 2\np 1\nv  0.10 0 0 1 .5 0 # red\nv 1 0 0\nv 0 1 0\nusemtl a b\nf 1 2 3\n";
  EXPECT_EQ(Appended(text, kPatch), text +
                                        "v 0.1 -0.3333333333333333 1e-07 1 .5 0\ng tilemend_filled\n"
                                        "usemtl grey\nf 1 3 4\n");
}

TEST(ObjTest, NamesMaterialsWhereTheyChangeAndTheFileThatDefinesThem) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n";
  const FilePatch patch = {{}, {}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}}, {}, {{0, "grey"}, {2, "blue"}}, "more.mtl"};
  EXPECT_EQ(Appended(text, patch), text +
                                       "mtllib more.mtl\ng tilemend_filled\nusemtl grey\nf 1 2 3\nf 1 2 4\n"
                                       "usemtl blue\nf 1 3 4\n");
}

TEST(ObjTexturesTest, FollowTheTriangles) {
  const auto obj = ParseTexturedObj(
      "mtllib a b.mtl \nmtllib c.mtl\r\nmtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0.25\nvt 1 0 0\n"
      "vt nan 1\nf 1 2 3\nusemtl wall red\nf 1/1 2/2 3/3 4/-3\nf 1 2\nusemtl roof\nf 1/2/1 2//1 3/9\nusemtl wall red\n",
      "a.obj");
  ASSERT_TRUE(obj.ok()) << obj.status();
  const ObjTextures& textures = obj->textures;
  EXPECT_THAT(textures.libraries, ElementsAre("a b.mtl", "c.mtl"));
  EXPECT_THAT(textures.materials, ElementsAre("wall red", "roof"));
  EXPECT_THAT(textures.corners,
              ElementsAre(Triangle{-1, -1, -1}, Triangle{0, 1, 2}, Triangle{0, 2, 0}, Triangle{1, -1, -1}));
  ASSERT_EQ(textures.runs.size(), 3U);
  EXPECT_EQ(textures.runs[0].first, 1);
  EXPECT_EQ(textures.runs[1].first, 3);
  EXPECT_EQ(textures.runs[1].material, 1);
  EXPECT_EQ(textures.runs[2].material, 0);
  ASSERT_EQ(textures.coordinates.size(), 3U);
  EXPECT_EQ(textures.coordinates[0], (std::array<float, 2>{0, 0.25}));
  EXPECT_TRUE(std::isnan(textures.coordinates[2][0]));
}

TEST(ObjTexturesTest, KnowFilledFacesByTheirGroup) {
  const auto obj = ParseTexturedObj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng tilemend_filled \nf 1 2 3\nf 1 2 3\ng a tilemend_filled\nf 1 2 3\ng\n",
      "a.obj");
  ASSERT_TRUE(obj.ok()) << obj.status();
  const auto& groups = obj->textures.groups;
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].first, 1);
  EXPECT_TRUE(groups[0].is_filled);
  EXPECT_EQ(groups[1].first, 3);
  EXPECT_FALSE(groups[1].is_filled);
}

TEST(ObjTexturesTest, HaveTheColoursOfVertices) {
  const auto colours = [](const std::string& vertices) {
    return ParseTexturedObj(vertices + "f 1 2 3\n", "a.obj").value().textures.vertex_colours;
  };
  EXPECT_THAT(colours("v 0 0 0 0 0.2 1\nv 1 0 0 0.6 2 -1 # bright\nv 0 1 0 1e-3 0.5 1\r\n"),
              ElementsAre(Rgb{0, 51, 255}, Rgb{153, 255, 0}, Rgb{0, 128, 255}));
  EXPECT_THAT(colours("v 0 0 0\nv 1 0 0 1\nv 0 1 0 1 1 1 1\n"), IsEmpty()) << "a weight, and what is not known";
  EXPECT_THAT(colours("v 0 0 0\nv 1 0 0 1 1 1\nv 0 1 0 x 1 1\n"),
              ElementsAre(std::nullopt, Rgb{255, 255, 255}, std::nullopt));
  EXPECT_THAT(colours("v 0 0 0 nan 1 1\nv 1 0 0\nv 0 1 0\n"), IsEmpty());
}

TEST(ObjTexturesTest, DamageInThemIsNoError) {
  const auto obj = ParseTexturedObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt\nvt x\nusemtl\nmtllib\nf 1/7 2/-9 3/0\n", "a.obj");
  ASSERT_TRUE(obj.ok()) << obj.status();
  EXPECT_THAT(obj->textures.corners, ElementsAre(Triangle{-1, -1, -1}));
  EXPECT_EQ(obj->textures.coordinates.size(), 2U);
}

TEST(ObjTest, AppendsInTheFilesLineEnding) {
  const std::string text = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3";
  EXPECT_EQ(Appended(text, {{{1, 2, 3}}, {-1}, {{0, 2, 3}}, {}, {{0, "grey"}}}),
            text + "\r\nv 1 2 3\r\ng tilemend_filled\r\nusemtl grey\r\nf 1 3 4\r\n");
  const std::string mac = "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r";
  EXPECT_EQ(Appended(mac, {{{1, 2, 3}}, {-1}, {}}), mac + "v 1 2 3\r");
}

TEST(ObjTest, DoesNotContinueABackslashAtTheEnd) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 \\\n";
  const auto file = Parse(Appended(text, kPatch));
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(ObjTest, AnEmptyPatchChangesNothing) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
  EXPECT_EQ(Appended(text, {}), text);
}

TEST(ObjTest, NamesTheLineOfAnError) {
  const std::string three = "v 0 0 0\nv 1 0 0\r\nv 0 1 0\n";
  EXPECT_EQ(MessageOf(three + "f 1 2 4\n"), "a.obj: line 4: expected a vertex index of at most 3, found 4");
  EXPECT_EQ(MessageOf(three + "f 1 0 2\n"), "a.obj: line 4: expected a vertex index in 1 to 3 or -3 to -1, found '0'");
  EXPECT_EQ(MessageOf(three + "f 1 -4 2\n"),
            "a.obj: line 4: expected a vertex index in 1 to 3 or -3 to -1, found '-4'");
  EXPECT_EQ(MessageOf(three + "f 1 2 3x\n"), "a.obj: line 4: expected v, v/vt, v//vn or v/vt/vn, found something else");
  EXPECT_EQ(MessageOf(three + "f 1 2 a\n"), "a.obj: line 4: expected a vertex index, found something else");
  EXPECT_EQ(MessageOf("v 0 0\nv 1 0 0\n"), "a.obj: line 1: expected a coordinate, found end of line");
  EXPECT_EQ(MessageOf("\nv 0 0 inf"),
            "a.obj: line 2: expected a coordinate that is finite and at most 1e9 m, found something else");
  EXPECT_EQ(MessageOf("v 0 0 1e10"),
            "a.obj: line 1: expected a coordinate that is finite and at most 1e9 m, found '1e10'");
  EXPECT_EQ(MessageOf("v 0 0 0x"), "a.obj: line 1: expected a coordinate, found something else");
  EXPECT_EQ(MessageOf(three + "\x01\x02 3\n"), "a.obj: line 4: expected an OBJ statement, found something else");
  EXPECT_THAT(MessageOf(three + "usemtl " + std::string(2 << 20, 'm')), HasSubstr("line 4: the line is longer than"));
}

TEST(ObjTest, RefusesOtherContent) {
  EXPECT_EQ(MessageOf(""), "a.obj: the file has no vertices");
  EXPECT_EQ(MessageOf("v 0 0 0\n"), "a.obj: the file has no faces");
  EXPECT_EQ(MessageOf("ply\nformat ascii 1.0\n"), "a.obj: line 1: expected an OBJ statement, found something else");
  EXPECT_EQ(MessageOf("OFF\n3 1 0\n"), "a.obj: line 1: expected an OBJ statement, found something else");
  EXPECT_EQ(MessageOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2"),
            "a.obj: line 5: the file ends within a face: it is cut off");
}

TEST(ObjTest, FlatFacesAreNoTrianglesUnlessTheyAreKept) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 1/2 2/1\nf 1 2\nusemtl a\nf 3/2 2/1 1/1 1/2\n";
  const auto left_out = ParseTexturedObj(text, "a.obj");
  ASSERT_TRUE(left_out.ok()) << left_out.status();
  EXPECT_EQ(left_out->file.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(left_out->textures.short_faces, 1);
  const auto kept = ParseTexturedObj(text, "a.obj", NoFaces::kRefuse, FlatFaces::kKeep);
  ASSERT_TRUE(kept.ok()) << kept.status();
  EXPECT_EQ(kept->file.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 0, 1}, {2, 1, 0}}));
  EXPECT_EQ(kept->textures.corners, (std::vector<Triangle>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}));
  EXPECT_EQ(kept->textures.runs.at(0).first, 2);
  EXPECT_EQ(kept->textures.short_faces, 1);
  EXPECT_EQ(kept->textures.lines_and_points, 0);
}

TEST(ObjTest, LinesAndPointsAreCounted) {
  const auto obj =
      ParseTexturedObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\nf 1 2 3\np 1\n# l 1 2\nl 2 \\\n 3\nlod 2\n", "a.obj");
  ASSERT_TRUE(obj.ok()) << obj.status();
  EXPECT_EQ(obj->textures.lines_and_points, 3);
  EXPECT_EQ(obj->textures.short_faces, 0);
}

TEST(ObjTest, AppendsTexturedFaces) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";
  FilePatch patch;
  patch.new_points = {{1, 1, 0}};
  patch.like = {-1};
  patch.triangles = {{1, 3, 2}};
  patch.texture_places = {{0.25F, 0.5F}, {0.125F, 1.0F}};
  patch.texture_corners = {{1, 0, 1}};
  EXPECT_EQ(Appended(text, patch),
            text + "v 1 1 0\nvt 0.250000 0.500000\nvt 0.125000 1.000000\ng tilemend_filled\nf 2/3 4/2 3/3\n");
  patch.texture_corners = {{1, 0, 2}};
  EXPECT_FALSE(AppendToObj(text, patch, "a.obj").ok());
  patch.texture_corners = {};
  EXPECT_FALSE(AppendToObj(text, patch, "a.obj").ok());
}

}  // namespace
}  // namespace tilemend
