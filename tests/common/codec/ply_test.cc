#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "common/codec/mesh_file.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;

template <class T>
std::string Bytes(T value, bool big_endian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

absl::StatusOr<MeshFile> Parse(const std::string& bytes) { return ParseMesh(MeshFormat::kPly, bytes, "a.ply"); }

std::string MessageOf(const std::string& bytes) {
  const absl::StatusOr<MeshFile> file = Parse(bytes);
  EXPECT_EQ(file.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(file.status().message());
}

// A file with a property of every kind around what is read, two triangles and a quad, and an element of edges.
struct OddPly {
  bool big_endian = false;
  std::string eol = "\n";
  std::string filled_property = "";
  std::string vertex_count = "4";
  std::string face_count = "3";

  std::string Header() const {
    std::string text = "ply|format binary_" + std::string(big_endian ? "big" : "little") +
                       "_endian 1.0|comment odd one|element vertex " + vertex_count +
                       "|property uchar red|property double x|property double y|property list uchar short spare"
                       "|property double z|obj_info made by hand|element face " +
                       face_count + "|property short kind|property list uint int vertex_index" +
                       "|property list uchar float texcoord|" + filled_property +
                       "element edge 1|property int vertex1|property int vertex2|end_header|";
    std::string out;
    for (const char c : text) c == '|' ? out += eol : out += c;
    return out;
  }
  std::string Vertex(uint8_t red, double x, double y, std::vector<int16_t> spare, double z) const {
    std::string out = Bytes(red, big_endian) + Bytes(x, big_endian) + Bytes(y, big_endian);
    out += static_cast<char>(spare.size());
    for (const int16_t value : spare) out += Bytes(value, big_endian);
    return out + Bytes(z, big_endian);
  }
  std::string Face(int16_t kind, std::vector<int32_t> corners, std::vector<float> texcoord) const {
    std::string out = Bytes(kind, big_endian) + Bytes(static_cast<uint32_t>(corners.size()), big_endian);
    for (const int32_t corner : corners) out += Bytes(corner, big_endian);
    out += static_cast<char>(texcoord.size());
    for (const float value : texcoord) out += Bytes(value, big_endian);
    return out;
  }
  std::vector<std::string> Vertices() const {
    return {Vertex(1, 0.1, 0, {}, -0.0), Vertex(2, 1e-300, 0.3, {7, -8}, 1), Vertex(3, 1, 1, {9}, 1e9),
            Vertex(255, 0, 1.0 / 3, {1, 2, 3}, 2)};
  }
  std::vector<std::string> Faces() const {
    return {Face(-5, {0, 1, 2}, {0, 0.5f, 1, 1, 0, 1}), Face(6, {0, 1, 2, 3}, {}), Face(7, {3, 2, 0}, {0.25f})};
  }
  std::string Edges() const { return Bytes(int32_t{0}, big_endian) + Bytes(int32_t{3}, big_endian); }
};

std::string Join(const std::vector<std::string>& parts, const std::string& after = "") {
  std::string out;
  for (const std::string& part : parts) out += part + after;
  return out;
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

TEST_P(OddPlyTest, AppendsWithEveryOriginalRecordByteForByte) {
  OddPly odd = ply();
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

INSTANTIATE_TEST_SUITE_P(EncodingsAndLineEndings, OddPlyTest,
                         ::testing::Combine(::testing::Bool(), ::testing::Values("\n", "\r\n", "\r")));

constexpr char kAsciiHeader[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nelement note 1\n"
    "property list int int code\nend_header\n";

TEST(PlyAsciiTest, AppendsBehindOriginalText) {
  const std::string before = std::string(kAsciiHeader) + "0.10 0 0  7\n1e0 0 0 8\r\n0\t1 0 9\n3 0 1 2\n2 5 6\n";
  const auto after =
      AppendPatch(MeshFormat::kPly, before, {{{0.1, 1.0 / 3, 2}, {1, 2, 3}}, {1, -1}, {{2, 3, 4}}}, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_THAT(*after, HasSubstr("element vertex 5\n"));
  EXPECT_THAT(*after, HasSubstr("vertex_indices\nproperty uchar tilemend_filled\nelement note"));
  EXPECT_THAT(*after, EndsWith("end_header\n0.10 0 0  7\n1e0 0 0 8\r\n0\t1 0 9\n0.1 0.3333333333333333 2 8\n1 2 3 0\n"
                               "3 0 1 2 0\n3 2 3 4 1\n2 5 6\n"));
}

TEST(PlyAsciiTest, AppendsFirstFaceToFileWithoutAny) {
  const std::string header = "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\n";
  const std::string before = header +
                             "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  const auto after = AppendPatch(MeshFormat::kPly, before, {{}, {}, {{0, 1, 2}}}, "a.ply");
  ASSERT_TRUE(after.ok()) << after.status();
  EXPECT_THAT(*after, EndsWith("end_header\n3 0 1 2 1\n0 0 0\n1 0 0\n0 1 0\n"));
}

TEST(PlyAsciiTest, IsDoubleWhateverTheHeaderSays) {
  const auto file = Parse(std::string(kAsciiHeader) + "0.1 0 0 7 1 0 0 8 0 1 0 9 3 0 1 2 0");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat64);
  EXPECT_EQ(file->mesh.points[0][0], 0.1);
}

TEST(PlyTest, NewFileReadsBackRoundedToItsNumberType) {
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

TEST(PlyTest, WidensIndicesThatDoNotFit) {
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
            at(odd.Header().size() + 9) + "a coordinate of at most 1e9 m, found nan");
}

TEST(PlyTest, NamesTheByteOfABadRecordOfFixedSize) {
  const FilePatch patch = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}}};
  const std::string good = NewPlyFile(patch, NumberType::kFloat32);
  const size_t body = good.find("end_header\n") + 11;
  for (const float bad : {std::nanf(""), HUGE_VALF, 1.1e9f, -2e9f}) {
    std::string file = good;
    file.replace(body + 16, 4, Bytes(bad, false));
    EXPECT_THAT(MessageOf(file), HasSubstr("byte " + std::to_string(body + 16) + ": expected a coordinate of at most"));
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
            "a.ply: line 14: expected a coordinate, found 'zero'");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 3\n0\n"),
            "a.ply: line 16: expected a vertex index in 0 to 2, found '3'");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n-3 0 1 3\n0\n"),
            "a.ply: line 16: expected a list count in 0 to 1000000, found '-3'");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1\n"),
            "a.ply: line 17: expected a vertex index in 0 to 2, found end of file");
  EXPECT_EQ(MessageOf(head + "0 0 0 7\n1 0 nan 8\n0 1 0 9\n3 0 1 2\n0\n"),
            "a.ply: line 14: expected a coordinate of at most 1e9 m, found 'nan'");
}

struct BadHeader {
  std::string from;
  std::string to;
  std::string message;
};
class PlyHeaderTest : public ::testing::TestWithParam<BadHeader> {};

TEST_P(PlyHeaderTest, RefusesWithReason) {
  std::string file = std::string(kAsciiHeader) + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n0\n";
  ASSERT_TRUE(Parse(file).ok());
  const size_t at = file.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  file.replace(at, GetParam().from.size(), GetParam().to);
  EXPECT_THAT(MessageOf(file), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, PlyHeaderTest,
    ::testing::Values(
        BadHeader{"ply\n", "plx\n", "line 1: expected 'ply', found 'plx'"},
        BadHeader{"format ascii 1.0\n", "", "expected a format line"},
        BadHeader{"ascii", "text", "line 2: expected ascii, binary_little_endian or binary_big_endian, found 'text'"},
        BadHeader{"1.0", "2.0", "line 2: expected version 1.0, found '2.0'"},
        BadHeader{"element vertex 3", "element vertex 4000000",
                  "expected 4000000 records of element vertex, found only"},
        BadHeader{"element vertex 3", "element vertex 9223372036854775807", "records of element vertex"},
        BadHeader{"element vertex 3", "element vertex -3", "line 3: expected a number of records, found '-3'"},
        BadHeader{"element vertex 3", "element vertex 0", "the file has no vertices"},
        BadHeader{"element vertex 3", "element point 3", "the file has no vertices"},
        BadHeader{"element note", "element face", "line 10: expected an element with a new name, found 'face'"},
        BadHeader{"element face", "element polygon", "the file has no faces"},
        BadHeader{"float x", "int x", "expected a float or double vertex property x"},
        BadHeader{"float y", "float x", "line 5: expected a property with a new name, found 'x'"},
        BadHeader{"float y", "float32_t y", "line 5: expected a type"},
        BadHeader{"float y", "float", "line 5: expected property TYPE NAME"},
        BadHeader{"list uchar int vertex_indices", "list float int vertex_indices",
                  "expected an integer type, found 'float'"},
        BadHeader{"list uchar int vertex_indices", "list uchar float vertex_indices", "expected an integer list"},
        BadHeader{"list uchar int vertex_indices", "int vertex_indices", "expected an integer list"},
        BadHeader{"end_header\n", "end_head\n", "line 12: expected a header line"},
        BadHeader{"element face 1", "element face 1\nnonsense", "expected a header line"}));

TEST(PlyTest, RefusesAHeaderWithoutEnd) {
  EXPECT_EQ(MessageOf("ply\nformat ascii 1.0\n"),
            "a.ply: byte 21: expected a header line or end_header, found end of file");
  EXPECT_THAT(MessageOf("ply\ncomment " + std::string(2 << 20, 'x')), HasSubstr("found one that is too long"));
}

TEST(PlyTest, RefusesABadPatch) {
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
