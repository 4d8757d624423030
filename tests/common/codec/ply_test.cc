#include "common/codec/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/codec/mesh_file.h"
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

std::string MessageOf(const std::string& bytes) {
  const absl::StatusOr<MeshFile> file = Parse(bytes);
  EXPECT_EQ(file.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(file.status().message());
}

class OddPlyTest : public ::testing::TestWithParam<std::tuple<bool, std::string>> {
 protected:
  OddPly ply() const { return {.big_endian = std::get<0>(GetParam()), .eol = std::get<1>(GetParam())}; }
};

TEST_P(OddPlyTest, ReadsPositionsAndFansAmongOddProperties) {
  const OddPly odd = ply();
  const auto file = Parse(odd.Header() + Join(odd.Vertices()) + Join(odd.Faces()) + odd.Edges());
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat64);
  EXPECT_THAT(file->mesh.points,
              ElementsAre(Point3(0.1, 0, -0.0), Point3(1e-300, 0.3, 1), Point3(1, 1, 1e9), Point3(0, 1.0 / 3, 2)));
  EXPECT_THAT(file->mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{3, 2, 0}));
  EXPECT_EQ(file->polygon_count, 1);
}

// An arrowhead, whose fan around the first corner has a triangle turned over.
TEST(PlyTest, CutsAPolygonThatStandsBeforeItsVertices) {
  const std::string begin = "ply\nformat ascii 1.0\n", end = "end_header\n",
                    of_vertex = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
                    of_face = "element face 1\nproperty list uchar int vertex_indices\n",
                    vertices = "0 0 0\n4 0 0\n4 4 0\n3 1 0\n", face = "4 0 1 2 3\n";
  const auto usual = Parse(begin + of_vertex + of_face + end + vertices + face),
             early = Parse(begin + of_face + of_vertex + end + face + vertices);
  ASSERT_TRUE(usual.ok() && early.ok()) << usual.status() << early.status();
  for (const Triangle& t : usual->mesh.triangles) EXPECT_THAT(t, ::testing::Not(::testing::IsSupersetOf({0, 2})));
  EXPECT_EQ(early->mesh.triangles, usual->mesh.triangles);
  EXPECT_EQ(early->mesh.points, usual->mesh.points);
  EXPECT_EQ(early->polygon_count, 1);
}

INSTANTIATE_TEST_SUITE_P(EncodingsAndLineEndings, OddPlyTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Values("\n", "\r\n", "\r")));

TEST(PlyAsciiTest, IsDoubleWhateverTheHeaderSays) {
  const auto file = Parse(std::string(kAsciiHeader) + "0.1 0 0 7 1 0 0 8 0 1 0 9 3 0 1 2 0");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat64);
  EXPECT_EQ(file->mesh.points[0][0], 0.1);
}

TEST(PlyTest, CountsBytesBehindTheLastRecord) {
  const std::string text = std::string(kAsciiHeader) + "0.1 0 0 7 1 0 0 8 0 1 0 9 3 0 1 2 0";
  const OddPly odd{.big_endian = false, .eol = "\n"};
  const std::string binary = odd.Header() + Join(odd.Vertices()) + Join(odd.Faces()) + odd.Edges();
  for (const std::string& bytes : {text, binary}) {
    for (const auto& [tail, count] : {std::pair("", 0), {" \n\n", 0}, {"\nmore", 5}, {" 0 ", 3}}) {
      const auto file = Parse(bytes + tail);
      ASSERT_TRUE(file.ok()) << file.status();
      EXPECT_EQ(file->bytes_after_end, count) << tail;
    }
  }
}

TEST(PlyTest, KeepsFacesWithoutSurfaceInTheFileOnly) {
  const std::string before = std::string(kAsciiHeader) + "0 0 0 7 1 0 0 8 0 1 0 9 3 0 1 0 0\n";
  const auto file = Parse(before);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(file->mesh.triangles.empty());
  const auto after = AppendPatch(MeshFormat::kPly, before, {{}, {}, {{0, 1, 2}}}, "a.ply");
  EXPECT_THAT(*after, EndsWith("3 0 1 0 0\n3 0 1 2 1 0\n"));
}

TEST(PlyTest, NamesTheByteOfABadBinaryValue) {
  const OddPly odd;
  const std::string head = odd.Header() + Join(odd.Vertices());
  const auto at = [](size_t offset) { return "a.ply: byte " + std::to_string(offset) + ": expected "; };
  std::vector<std::string> faces = odd.Faces();
  faces[1] = odd.Face(6, {0, 1, 4, 3}, {});
  EXPECT_EQ(MessageOf(head + Join(faces) + odd.Edges()),
            at(head.size() + faces[0].size() + 14) + "a vertex index in 0 to 3, found 4");
  faces[1] = odd.Face(6, {0, -1, 2}, {});
  EXPECT_THAT(MessageOf(head + Join(faces) + odd.Edges()), EndsWith("a vertex index in 0 to 3, found -1"));
  EXPECT_EQ(MessageOf(head + Join(odd.Faces()) + odd.Edges().substr(0, 7)),
            at(head.size() + Join(odd.Faces()).size() + 4) + "a value of vertex2, found end of file");
  std::vector<std::string> vertices = odd.Vertices();
  vertices[0] = odd.Vertex(1, 0, std::nan(""), {}, 0);
  EXPECT_EQ(MessageOf(odd.Header() + Join(vertices) + Join(odd.Faces()) + odd.Edges()),
            at(odd.Header().size() + 9) + "a coordinate that is finite and at most 1e9 m, found nan");
}

TEST(PlyTest, NamesTheByteOfABadRecordOfFixedSize) {
  const FilePatch patch = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}}};
  const std::string good = NewPlyFile(patch, NumberType::kFloat32);
  const size_t body = good.find("end_header\n") + 11;
  for (const float bad : {std::nanf(""), HUGE_VALF, 1.1e9f, -2e9f}) {
    std::string file = good;
    file.replace(body + 16, 4, Bytes(bad, false));
    EXPECT_THAT(MessageOf(file),
                HasSubstr("byte " + std::to_string(body + 16) + ": expected a coordinate that is finite and at most"));
  }
  std::string file = good;
  file.replace(body + 36 + 5, 4, Bytes(int32_t{3}, false));
  EXPECT_EQ(MessageOf(file),
            "a.ply: byte " + std::to_string(body + 41) + ": expected a vertex index in 0 to 2, found 3");
  EXPECT_THAT(MessageOf(good.substr(0, good.size() - 2)),
              HasSubstr("expected a vertex index in 0 to 2, found end of file"));
}

TEST(PlyTest, NamesTheLineOfABadText) {
  const std::string head = kAsciiHeader;
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 zero 0 8\n0 1 0 9\n3 0 1 2\n0\n"),
            "a.ply: line 14: expected a coordinate, found something else");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 3\n0\n"),
            "a.ply: line 16: expected a vertex index in 0 to 2, found '3'");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n-3 0 1 3\n0\n"),
            "a.ply: line 16: expected a list count in 0 to 1000000, found '-3'");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1\n"),
            "a.ply: line 17: expected a vertex index in 0 to 2, found end of file");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 nan 8\n0 1 0 9\n3 0 1 2\n0\n"),
            "a.ply: line 14: expected a coordinate that is finite and at most 1e9 m, found something else");
}

}  // namespace
}  // namespace tilemend
