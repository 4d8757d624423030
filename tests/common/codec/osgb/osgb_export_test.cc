// Files of a real export: every one is read to its last byte, takes new geometry and gives triangles away, with
// everything else as it was; cut or changed files are refused or read, within bounds of memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/util/files.h"
#include "tests/common/codec/osgb/osgb_checks.h"
#include "tests/fuzz/osgb_property.h"
#include "tests/support/osgb_builder.h"

namespace tilemend {
namespace {

// A few changes at places that depend on `seed` alone. Bytes near the beginning change more often: counts and classes
// stand there, images and coordinates behind.
std::string Mutated(std::string bytes, uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  for (size_t step = 0; step <= below(4); ++step) {
    if (bytes.size() < 8) break;
    const size_t at = below(below(2) == 0 ? std::min<size_t>(bytes.size(), 2048) : bytes.size());
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(at, 1 + below(16));
        break;
      case 3:
        bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(64)));
        break;
      default:
        for (size_t i = at; i < std::min(at + 4, bytes.size()); ++i)
          bytes[i] = static_cast<char>(below(2) == 0 ? 0xff : 0);
    }
  }
  return bytes;
}

TEST(OsgbExportTest, FilesAreThere) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  EXPECT_GE(SharedOsgbFiles().size(), 40u);
}

TEST(OsgbExportTest, EveryFileIsReadAndEdited) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  for (const auto& path : SharedOsgbFiles()) {
    const absl::StatusOr<std::string> bytes = ReadFile(path.string());
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    const absl::StatusOr<OsgbFile> file = ReadOsgb(*bytes, path.string());
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(file->geometries.size(), file->paged_lods.size()) << path;
    EXPECT_EQ(file->images.size(), file->geometries.size()) << path;
    EXPECT_EQ(OsgbPropertyViolation(*bytes), "") << path;
  }
}

// 2 * radius / range is the texel in metres, a power of two by the level in the name.
TEST(OsgbExportTest, RangesFollowTheLevel) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  for (const auto& path : SharedOsgbFiles()) {
    const std::string name = path.filename().string();
    const size_t at = name.find("_L");
    const int level = at == std::string::npos ? 14 : std::stoi(name.substr(at + 2));
    const absl::StatusOr<OsgbFile> file = ReadOsgb(*ReadFile(path.string()), name);
    ASSERT_TRUE(file.ok()) << file.status();
    for (const OsgbPagedLod& lod : file->paged_lods) {
      ASSERT_TRUE(lod.has_center && lod.range_is_pixels);
      EXPECT_NEAR(2 * lod.radius / lod.children.at(0).range_hi * std::exp2(level - 16), 1, 1e-5) << name;
    }
  }
}

TEST(OsgbExportTest, EveryFileCutAt50PlacesIsRefused) {
  if (SharedOsgbFiles().empty()) GTEST_SKIP() << kNoSharedOsgb;
  for (const auto& path : SharedOsgbFiles()) {
    const absl::StatusOr<std::string> bytes = ReadFile(path.string());
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    for (size_t k = 0; k < 50; ++k) {
      // A copy on the heap, so that a sanitizer sees a read beyond the end.
      const std::string cut = bytes->substr(0, k < 25 ? bytes->size() * k / 25 : (k - 25) * 40);
      EXPECT_EQ(OsgbRefusal(cut).substr(0, 13), "a.osgb: byte ") << path << " " << k;
    }
  }
}

TEST(OsgbExportTest, ChangedFilesKeepTheProperty) {
  std::vector<std::string> files;
  for (const auto& path : SharedOsgbFiles()) {
    if (std::filesystem::file_size(path) < 200000) files.push_back(*ReadFile(path.string()));
  }
  for (const uint32_t version : kOsgbVersions) files.push_back(BuiltOsgbScene(version));
  int read = 0;
  for (uint64_t seed = 0; seed < 10000; ++seed) {
    const std::string bytes = Mutated(files[seed % files.size()], seed);
    read += OsgbRefusal(bytes).empty() ? 1 : 0;
    ASSERT_EQ(OsgbPropertyViolation(bytes), "") << seed;
  }
  EXPECT_GT(read, 500);  // so that appending and dropping are tried as well
}

}  // namespace
}  // namespace tilemend
