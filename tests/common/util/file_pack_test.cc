#include "common/util/file_pack.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;

const std::vector<PackedFile> kFiles = {{"a.osgb", "first"}, {"b.osgb", ""}, {"c d.osgb", std::string_view("\0x", 2)}};

TEST(FilePackTest, GivesBackWhatWasPacked) {
  const std::string pack = PackFiles(kFiles);
  EXPECT_TRUE(IsFilePack(pack));
  const auto files = UnpackFiles(pack, "tile");
  ASSERT_TRUE(files.ok()) << files.status();
  ASSERT_EQ(files->size(), 3u);
  for (size_t f = 0; f < 3; ++f) {
    EXPECT_EQ((*files)[f].name, kFiles[f].name);
    EXPECT_EQ((*files)[f].bytes, kFiles[f].bytes);
  }
}

TEST(FilePackTest, RefusesWhatIsCutOff) {
  const std::string pack = PackFiles(kFiles);
  for (size_t size = 0; size < pack.size(); ++size) {
    const auto files = UnpackFiles(std::string_view(pack).substr(0, size), "tile");
    // Between two files a pack with fewer of them ends.
    if (files.ok()) {
      EXPECT_LT(files->size(), 3u) << size;
    } else {
      EXPECT_THAT(files.status().message(), HasSubstr("tile: at byte ")) << size;
    }
  }
}

TEST(FilePackTest, RefusesASizeBeyondTheEnd) {
  std::string pack = PackFiles({{"a", "b"}});
  pack[pack.size() - 9] = '\x7f';  // the size's highest byte
  EXPECT_FALSE(UnpackFiles(pack, "tile").ok());
  EXPECT_FALSE(IsFilePack("ply\n"));
}

}  // namespace
}  // namespace tilemend
