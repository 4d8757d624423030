#include "common/codec/stl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace tilemend {
namespace {

using ::testing::HasSubstr;

constexpr char kText[] =
    "solid a part\r\nfacet normal nan nan nan\r\nouter loop\r\nvertex 0 0 0\r\nvertex 1.5 0 0\r\nvertex 0 1e-3 0\r\n"
    "endloop\r\nendfacet\r\nendsolid a part\r\n";

std::string Binary(const std::vector<float>& corners) {
  std::string bytes(80, 's');
  const auto append = [&](const void* value, size_t size) { bytes.append(static_cast<const char*>(value), size); };
  const auto count = static_cast<uint32_t>(corners.size() / 9);
  append(&count, 4);
  for (size_t f = 0; f < count; ++f) {
    bytes.append(12, '\0');
    append(&corners[9 * f], 36);
    bytes.append(2, '\7');
  }
  return bytes;
}

const std::vector<float> kCorners = {0, 0, 0, 1.5F, 0, 0, 0, 0.1F, 0};

TEST(StlTest, ReadsTextWhateverTheNameAndTheNormals) {
  const auto file = ParseStl(kText, "a.stl");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat64);
  ASSERT_EQ(file->mesh.triangles.size(), 1u);
  EXPECT_EQ(file->mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(file->mesh.points[2], Point3(0, 1e-3, 0));
}

TEST(StlTest, ReadsTextInCapitalsAndWithOldLineEndings) {
  std::string capitals = kText, old = kText;
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  old.erase(std::remove(old.begin(), old.end(), '\n'), old.end());
  FilePatch patch;
  patch.triangles = {{2, 1, 0}};
  for (const std::string& bytes : {capitals, old}) {
    const auto out = AppendToStl(bytes, patch, "a.stl");
    ASSERT_TRUE(out.ok()) << out.status();
    const auto file = ParseStl(*out, "out.stl");
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_EQ(file->mesh.triangles.size(), 2u);
    EXPECT_EQ(file->mesh.points[2], Point3(0, 1e-3, 0));
  }
}

TEST(StlTest, ReadsAndKeepsAByteOrderMark) {
  const std::string marked = std::string("\xef\xbb\xbf") + kText;
  FilePatch patch;
  patch.triangles = {{2, 1, 0}};
  const auto out = AppendToStl(marked, patch, "a.stl");
  ASSERT_TRUE(out.ok()) << out.status();
  EXPECT_TRUE(out->starts_with("\xef\xbb\xbfsolid"));
  const auto file = ParseStl(*out, "out.stl");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->mesh.triangles.size(), 2u);
}

TEST(StlTest, ReadsBinaryEvenIfItBeginsWithSolid) {
  std::string bytes = Binary(kCorners);
  std::memcpy(bytes.data(), "solid", 5);
  const auto file = ParseStl(bytes, "a.stl");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->number_type, NumberType::kFloat32);
  EXPECT_EQ(file->mesh.points[2], Point3(0, 0.1F, 0));
}

TEST(StlTest, AppendsFacetsAndKeepsTheRest) {
  FilePatch patch;
  patch.new_points = {Point3(1, 1, 0.1)};
  patch.like = {-1};
  patch.triangles = {{2, 1, 3}};
  for (const std::string& bytes : {std::string(kText), Binary(kCorners)}) {
    const auto out = AppendToStl(bytes, patch, "a.stl");
    ASSERT_TRUE(out.ok()) << out.status();
    const auto file = ParseStl(*out, "b.stl");
    ASSERT_TRUE(file.ok()) << file.status();
    ASSERT_EQ(file->mesh.triangles.size(), 2u);
    EXPECT_EQ(file->mesh.points[3], file->mesh.points[2]);
    EXPECT_EQ(file->mesh.points[4], file->mesh.points[1]);
    EXPECT_EQ(file->mesh.points[5], RoundedTo(file->number_type, patch.new_points[0]));
  }
  EXPECT_THAT(*AppendToStl(kText, patch, "a.stl"), testing::EndsWith("endfacet\r\nendsolid a part\r\n"));
  patch.triangles = {{2, 1, 4}};
  EXPECT_FALSE(AppendToStl(kText, patch, "a.stl").ok());
}

TEST(StlTest, AppendsFacetsBeforeTheLastEndOfASolidHoweverItIsWritten) {
  const std::string facets(kText, std::string(kText).find("endsolid"));
  FilePatch patch;
  patch.triangles = {{2, 1, 0}};
  for (const std::string end : {"endsolid plate (endsolid)\r\n", "EndSolid x\r\n", "endsolid\r\n", ""}) {
    const auto out = AppendToStl(facets + end, patch, "a.stl");
    ASSERT_TRUE(out.ok()) << out.status();
    EXPECT_THAT(*out, testing::StartsWith(facets + "facet normal"));
    EXPECT_THAT(*out, testing::EndsWith("endfacet\r\n" + end));
    const auto file = ParseStl(*out, "out.stl");
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(file->mesh.triangles.size(), 2u);
  }
}

TEST(StlTest, SaysWhereAFileIsWrong) {
  std::string short_of_facets = Binary(kCorners);
  std::memcpy(short_of_facets.data(), "solid", 5);
  short_of_facets[80] = 7;
  EXPECT_THAT(ParseStl(short_of_facets, "a.stl").status().message(), HasSubstr("the header says 7 facets"));
  const auto message = [](const std::string& bytes) {
    return std::string(ParseStl(bytes, "a.stl").status().message());
  };
  EXPECT_THAT(message(""), HasSubstr("a.stl: byte 0: expected `solid`"));
  EXPECT_THAT(message("solid\nendsolid\n"), HasSubstr("no vertices"));
  EXPECT_THAT(message("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex"),
              HasSubstr("line 5: expected a coordinate"));
  EXPECT_THAT(message("solid\nfacet normal 0 0 1\nloop\n"), HasSubstr("line 3: expected `outer`"));
  EXPECT_THAT(message("solid\nfacet normal 0 0 1 outer loop vertex 1 2 1e10"), HasSubstr("at most 1e9"));
  const std::string bytes = Binary(kCorners);
  EXPECT_THAT(message(bytes.substr(0, bytes.size() - 1)), HasSubstr("byte 80: the header says 1 facets"));
  std::vector<float> bad = kCorners;
  bad[4] = NAN;
  EXPECT_THAT(message(Binary(bad)), HasSubstr("byte 112: expected a coordinate"));
}

}  // namespace
}  // namespace tilemend
