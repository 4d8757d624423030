#include "common/codec/ply_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/common/codec/odd_ply.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using testing::kAsciiHeader;
using testing::OddPly;

std::string MessageOf(const std::string& bytes) {
  const absl::StatusOr<PlyHeader> header = ParsePlyHeader(bytes, "a.ply");
  EXPECT_EQ(header.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(header.status().message());
}

TEST(PlyHeaderTest, SaysWhereEverythingIs) {
  const std::string text = std::string(kAsciiHeader) + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n0\n";
  const auto header = ParsePlyHeader(text, "a.ply");
  ASSERT_TRUE(header.ok()) << header.status();
  EXPECT_EQ(header->encoding, PlyEncoding::kAscii);
  EXPECT_EQ(header->eol, "\n");
  EXPECT_EQ(text.substr(header->body_begin, 3), "0 0");
  ASSERT_EQ(header->elements.size(), 3u);
  EXPECT_EQ(header->vertex, 0u);
  EXPECT_EQ(header->face, 1u);
  EXPECT_EQ(header->xyz, (std::array<size_t, 3>{0, 1, 2}));
  const PlyElement& face = header->elements[1];
  EXPECT_EQ(text.substr(face.count_begin, face.count_end - face.count_begin), "1");
  EXPECT_EQ(text.substr(face.end, 12), "element note");
  const PlyProperty& corners = face.properties[header->corners];
  EXPECT_TRUE(corners.is_list);
  EXPECT_EQ(corners.count_type, PlyType::kUint8);
  EXPECT_EQ(corners.type, PlyType::kInt32);
  EXPECT_EQ(text.substr(corners.type_begin, corners.type_end - corners.type_begin), "int");
}

TEST(PlyHeaderTest, KnowsTheLeastBytesOfARecord) {
  const OddPly odd;
  const std::string text = odd.Header() + std::string(1000, '\0');
  const auto header = ParsePlyHeader(text, "a.ply");
  ASSERT_TRUE(header.ok()) << header.status();
  EXPECT_EQ(header->encoding, PlyEncoding::kLittleEndian);
  EXPECT_EQ(header->xyz, (std::array<size_t, 3>{1, 2, 4}));
  EXPECT_EQ(header->elements[0].LeastRecordBytes(), 1u + 8 + 8 + 1 + 8);
  EXPECT_EQ(header->elements[1].LeastRecordBytes(), 2u + 4 + 1);
  EXPECT_TRUE(header->elements[0].HasLists());
  EXPECT_FALSE(header->elements[2].HasLists());
}

TEST(PlyHeaderTest, GoesByTheFirstLineEnd) {
  for (const std::string eol : {"\n", "\r\n", "\r"}) {
    const OddPly odd{.eol = eol};
    const std::string text = odd.Header() + "\n" + std::string(1000, '\r');
    const auto header = ParsePlyHeader(text, "a.ply");
    ASSERT_TRUE(header.ok()) << header.status();
    EXPECT_EQ(header->eol, eol);
    EXPECT_EQ(header->body_begin, odd.Header().size());
  }
}

TEST(PlyHeaderTest, TakesBothNamesOfEveryType) {
  const std::pair<const char*, PlyType> names[] = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64}};
  for (const auto& [name, type] : names) {
    std::string text = std::string(kAsciiHeader) + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n0\n";
    text.replace(text.find("uchar red"), 5, name);
    const auto header = ParsePlyHeader(text, "a.ply");
    ASSERT_TRUE(header.ok()) << header.status();
    EXPECT_EQ(header->elements[0].properties[3].type, type) << name;
  }
}

struct BadHeader {
  std::string from;
  std::string to;
  std::string message;
};
class BadPlyHeaderTest : public ::testing::TestWithParam<BadHeader> {};

TEST_P(BadPlyHeaderTest, RefusesWithReason) {
  std::string file = std::string(kAsciiHeader) + "0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n0\n";
  ASSERT_TRUE(ParsePlyHeader(file, "a.ply").ok());
  const size_t at = file.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  file.replace(at, GetParam().from.size(), GetParam().to);
  EXPECT_THAT(MessageOf(file), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Bad, BadPlyHeaderTest,
    ::testing::Values(
        BadHeader{"ply\n", "plx\n", "line 1: expected 'ply', found something else"},
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

TEST(PlyHeaderTest, RefusesAHeaderWithoutEnd) {
  EXPECT_EQ(MessageOf("ply\nformat ascii 1.0\n"),
            "a.ply: byte 21: expected a header line or end_header, found end of file");
  EXPECT_THAT(MessageOf("ply\ncomment " + std::string(2 << 20, 'x')), HasSubstr("found one that is too long"));
}

}  // namespace
}  // namespace tilemend
