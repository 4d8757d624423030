// Tiles of a real tileset: every one is read, takes new geometry and gives triangles away, with everything else as it
// was; cut or changed files are refused or read.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "common/codec/tiles3d/tileset.h"
#include "common/util/files.h"
#include "tests/common/codec/gltf/gltf_checks.h"
#include "tests/fuzz/gltf_property.h"

namespace tilemend {
namespace {

// A few changes at places that depend on `seed` alone; more often in the JSON than behind it.
std::string Mutated(std::string bytes, uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  for (size_t step = 0; step <= below(4); ++step) {
    const size_t at = below(below(2) == 0 ? std::min<size_t>(bytes.size(), 2048) : bytes.size());
    switch (below(4)) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>('0' + below(10));
        break;
      case 2:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      default:
        for (size_t i = at; i < std::min(at + 4, bytes.size()); ++i)
          bytes[i] = static_cast<char>(below(2) == 0 ? 0xff : 0);
    }
  }
  return bytes;
}

std::vector<std::string> Files() {
  std::vector<std::string> files;
  for (const auto& [name, bytes] : GltfSampleFiles()) files.push_back(bytes);
  for (const auto& path : SharedTiles()) {
    if (files.size() < 30) files.push_back(ReadFile(path.string()).value());
  }
  return files;
}

TEST(GltfExportTest, EveryTileIsReadAndEdited) {
  if (SharedTiles().empty()) GTEST_SKIP() << kNoSharedTiles;
  for (const auto& path : SharedTiles()) {
    EXPECT_EQ(GltfPropertyViolation(ReadFile(path.string()).value()), "") << path;
  }
}

TEST(GltfExportTest, TheTilesetIsReadAndWrittenAsItWas) {
  if (SharedTiles().empty()) GTEST_SKIP() << kNoSharedTiles;
  const FolderSource source(SharedTilesFolder().string());
  const absl::StatusOr<Tileset> tileset = ReadTileset(source, "tileset.json");
  ASSERT_TRUE(tileset.ok()) << tileset.status();
  EXPECT_GT(tileset->tiles.size(), 200u);
  EXPECT_EQ(tileset->documents[0].up, GltfUpAxis::kZ);
  EXPECT_EQ(WriteTilesetDocument(*tileset, 0), source.Read("tileset.json").value());
  // The sample lacks the models of one quarter.
  std::set<std::string> named;
  for (const TilesetTile& tile : tileset->tiles) named.insert(tile.content);
  for (const auto& path : SharedTiles()) EXPECT_TRUE(named.contains(path.filename().string())) << path;
}

TEST(GltfExportTest, EveryFileCutAt50PlacesIsRefused) {
  for (const std::string& bytes : Files()) {
    for (size_t k = 0; k < 50; ++k) {
      // A copy on the heap, so that a sanitizer sees a read beyond the end.
      const std::string cut = bytes.substr(0, k < 25 ? bytes.size() * k / 25 : (k - 25) * 4);
      EXPECT_EQ(GltfRefusal(cut).substr(0, 12), "a.glb: byte ") << k;
    }
  }
}

TEST(GltfExportTest, ChangedFilesKeepTheProperty) {
  const std::vector<std::string> files = Files();
  int read = 0;
  for (uint64_t seed = 0; seed < 10000; ++seed) {
    const std::string bytes = Mutated(files[seed % files.size()], seed);
    read += GltfRefusal(bytes).empty() ? 1 : 0;
    ASSERT_EQ(GltfPropertyViolation(bytes), "") << seed;
  }
  EXPECT_GT(read, 500);  // so that changing is tried as well
}

}  // namespace
}  // namespace tilemend
