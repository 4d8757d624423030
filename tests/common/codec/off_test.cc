#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/codec/mesh_file.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

absl::StatusOr<MeshFile> Parse(const std::string& text) { return ParseMesh(MeshFormat::kOff, text, "a.off"); }

std::string MessageOf(const std::string& text) {
  const absl::StatusOr<MeshFile> file = Parse(text);
  EXPECT_EQ(file.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(file.status().message());
}

std::string Appended(const std::string& text, const FilePatch& patch) {
  const absl::StatusOr<std::string> out = AppendPatch(MeshFormat::kOff, text, patch, "a.off");
  EXPECT_TRUE(out.ok()) << out.status();
  return out.value_or("");
}

const FilePatch kPatch = {{{0.1, 2, 3}, {4, 5, 6}}, {1, -1}, {{0, 3, 4}, {0, 1, 3}}};

class OffFormTest : public ::testing::TestWithParam<std::string> {};

TEST_P(OffFormTest, ReadsTheSameTriangle) {
  const auto file = Parse(GetParam());
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.points, ElementsAre(Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0)));
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
}

INSTANTIATE_TEST_SUITE_P(
    Forms, OffFormTest,
    ::testing::Values("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2",
                      "  # c\n\n OFF # c\n\t3\n1\n0 # c\n\n0 0 0 # c\n#\n1 0 0\n\n0 1 0\n3 0 1 2 # c\n",
                      "COFF\n3 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2 0.5 0.5 0.5\n",
                      "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 255 0 0\n",
                      "STOFF\n3 1 0\n0 0 0 0 0\n1 0 0 0 1\n0 1 0 1 1\n3 0 1 2\n", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
                      "OFF\n3 1 0\n0 0 0 1 0 0 0 1 0\n3 0 1 2 9 9 9\n", "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
                      "COFF 3 1 0 0 0 0 9 9 9 9 1 0 0 9 9 9 9 0 1 0\n9 9 9 9 3 0 1 2"));

TEST_P(OffFormTest, AppendsAPatch) {
  const auto file = Parse(Appended(GetParam(), kPatch));
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.points,
              ElementsAre(Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(0.1, 2, 3), Point3(4, 5, 6)));
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 3, 4}, Triangle{0, 1, 3}));
}

TEST(OffTest, AppendsBetweenAndAfterOriginalLines) {
  EXPECT_EQ(Appended("COFF # c\n3 1 3\n0 0 0 9 8 7 1\n1 0 0  6 5 4 1 # v\n0 1 0 3 2 1 1\n3 0 1 2 0.5 0.5 0.5", kPatch),
            "COFF # c\n5 3 3\n0 0 0 9 8 7 1\n1 0 0  6 5 4 1 # v\n0 1 0 3 2 1 1\n0.1 2 3 6 5 4 1\n4 5 6 0 0 0 0\n"
            "3 0 1 2 0.5 0.5 0.5\n3 0 3 4\n3 0 1 3\n");
}

TEST(OffTest, FindsFurtherColumnsOfVerticesThatShareALine) {
  EXPECT_EQ(Appended("COFF 3 1 0 0 0 0 9 8 7\n1 1 0 0 6 5 # c\n4 1 0 1 0 3 2 1 1 3 0 1 2", kPatch),
            "COFF 5 3 0 0 0 0 9 8 7\n1 1 0 0 6 5 # c\n4 1 0 1 0 3 2 1 1 0.1 2 3 6 5 4 1\n4 5 6 0 0 0 0 3 0 1 2\n"
            "3 0 3 4\n3 0 1 3\n");
}

TEST(OffTest, DoesNotAppendToTextThatEndsBeforeItsData) {
  for (const char* text : {"OFF\n3 1 0\n0 0 0      \n1 0 0        \n", "OFF 3 9 0 0 0 0 1 0 0 0 1 0 3 0 1 2 3 0 1 2   ",
                           "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"}) {
    const absl::StatusOr<std::string> out = AppendPatch(MeshFormat::kOff, text, kPatch, "a.off");
    EXPECT_EQ(out.status().code(), absl::StatusCode::kInvalidArgument) << text;
  }
}

TEST(OffTest, TakesLinesOfTheGreatestLength) {
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n", tail = "\n0 1 0\n3 0 1 2\n";
  EXPECT_TRUE(Parse(head + "#" + std::string((1 << 20) - 1, 'c') + tail).ok());
  EXPECT_THAT(MessageOf(head + "#" + std::string(1 << 20, 'c') + tail), HasSubstr("line 5: the line is longer than"));
}

TEST(OffTest, FansPolygonsAndSkipsFacesWithoutSurface) {
  const auto file = Parse("OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n2 0 1\n3 0 1 0\n0\n");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_EQ(file->polygon_count, 1);
}

TEST(OffTest, NamesTheLineOfAnError) {
  EXPECT_EQ(MessageOf(""), "a.off: line 1: expected OFF, COFF, NOFF or STOFF, found end of file");
  EXPECT_EQ(MessageOf("ply\n"), "a.off: line 1: expected OFF, COFF, NOFF or STOFF, found something else");
  EXPECT_EQ(MessageOf("4OFF\n"), "a.off: line 1: expected OFF, COFF, NOFF or STOFF, found something else");
  EXPECT_EQ(MessageOf("OFF BINARY\n"), "a.off: line 1: expected the number of vertices, found something else");
  EXPECT_EQ(MessageOf("OFF\n-3 1 0\n"), "a.off: line 2: expected the number of vertices, found '-3'");
  EXPECT_EQ(MessageOf("OFF\n0 0 0\n"), "a.off: the file has no vertices");
  EXPECT_EQ(MessageOf("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "a.off: the file has no faces");
  EXPECT_EQ(MessageOf("OFF\n2000000000 1 0\n0 0 0\n"),
            "a.off: line 2: expected data of 2000000000 vertices and 1 faces, found only 7 bytes");
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n";
  EXPECT_EQ(MessageOf(head + "0 x 0\n3 0 1 2\n"), "a.off: line 5: expected a coordinate, found something else");
  EXPECT_EQ(MessageOf(head + "0 0\n3 0 1 2\n"), "a.off: line 5: expected a coordinate, found end of line");
  EXPECT_EQ(MessageOf(head + "0 nan 0\n3 0 1 2\n"),
            "a.off: line 5: expected a coordinate that is finite and at most 1e9 m, found something else");
  EXPECT_EQ(MessageOf(head + "0 1 0\n3 0 1 3\n"), "a.off: line 6: expected a vertex index in 0 to 2, found '3'");
  EXPECT_EQ(MessageOf(head + "0 1 0\n3 0 1\n"), "a.off: line 6: expected a vertex index in 0 to 2, found end of line");
  EXPECT_EQ(MessageOf(head + "0 1 0\n-3 0 1 2\n"),
            "a.off: line 6: expected the number of corners of a face, found '-3'");
  EXPECT_EQ(MessageOf("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "a.off: line 7: expected the number of corners of a face, found end of file");
  EXPECT_THAT(MessageOf("OFF\n# " + std::string(2 << 20, 'c')), HasSubstr("line 2: the line is longer than"));
}

}  // namespace
}  // namespace tilemend
