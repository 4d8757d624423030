#include "common/gis/vector_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> NamesOf(const VectorBytes& file) {
  std::vector<std::string> names;
  for (const SideFile& side : file.beside) names.push_back(side.name + "=" + side.bytes);
  return names;
}

TEST(ReadAreaFileTest, AFileWithALogIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("lakes.gpkg", "SQLite format 3");
  EXPECT_TRUE(ReadAreaFile(path).ok());
  folder.Write("lakes.gpkg-wal", "changes");
  const absl::Status open = ReadAreaFile(path).status();
  EXPECT_TRUE(absl::IsInvalidArgument(open)) << open;
  EXPECT_THAT(std::string(open.message()), HasSubstr("lakes.gpkg-wal"));
  EXPECT_TRUE(absl::IsNotFound(ReadAreaFile(folder / "none.gpkg").status()));
}

TEST(ReadAreaFileTest, WhatIsNoFileIsRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(std::string(ReadAreaFile("https://example.com/lakes.zip").status().message()), HasSubstr("a URL"));
  EXPECT_THAT(std::string(ReadAreaFile(std::string("a.json\0b", 8)).status().message()), HasSubstr("a NUL"));
  EXPECT_TRUE(absl::IsInvalidArgument(ReadAreaFile(folder / ".").status()));
  for (const char* path : {"/vsicurl/https.shp", "/vsimem/a.shp", "/vsistdin/"})
    EXPECT_TRUE(absl::IsNotFound(ReadAreaFile(path).status())) << path;
}

TEST(ReadAreaFileTest, AShapefileBringsTheFilesBesideIt) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("lakes.SHP", "s");
  folder.Write("lakes.dbf", "d");
  folder.Write("lakes.SHX", "x");
  folder.Write("lakes.txt", "no");
  folder.Write("others.dbf", "no");
  const auto file = ReadAreaFile(path);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->bytes, "s");
  EXPECT_THAT(NamesOf(*file), ElementsAre("dbf=d", "shx=x"));
  const auto other = ReadAreaFile(folder / "lakes.txt");
  ASSERT_TRUE(other.ok()) << other.status();
  EXPECT_THAT(other->beside, IsEmpty());
}

TEST(ReadAreaFileTest, AGeodatabaseIsAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "lakes.gdb");
  folder.Write("lakes.gdb/timestamps", "t");
  folder.Write("lakes.gdb/a00000001.gdbtable", "a");
  const auto file = ReadAreaFile(folder / "lakes.gdb");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->bytes, "");
  EXPECT_THAT(NamesOf(*file), ElementsAre("a00000001.gdbtable=a", "timestamps=t"));
}

TEST(ContentOfTest, TellsFilesApartByAllOfTheirBytes) {
  EXPECT_EQ(ContentOf({"abc"}), "abc");
  const std::vector<VectorBytes> files = {
      {"a"}, {"a", {{"dbf", "b"}}}, {"a", {{"dbf", "c"}}}, {"a", {{"shx", "b"}}}, {"a", {{"dbf", ""}, {"shx", "b"}}}};
  for (size_t i = 0; i < files.size(); ++i) {
    for (size_t j = 0; j < i; ++j) EXPECT_NE(ContentOf(files[i]), ContentOf(files[j])) << i << " " << j;
  }
}

}  // namespace
}  // namespace tilemend
