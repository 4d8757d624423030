#include "coordinator/jobs/checked_files.h"

#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "common/util/tile_files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class CheckedFilesTest : public ::testing::Test {
 protected:
  CheckedFilesTest() {
    tile_.set_root(folder_.path());
    tile_.set_path("tile/a.osgb");
    folder_.Write("tile/a.osgb", "root");
    folder_.Write("tile/a_L1.osgb", "finer");
  }
  const TemporaryFolder folder_;
  v1::TileRef tile_;
};

TEST_F(CheckedFilesTest, ATreeIsReadAsTheWorkerDoes) {
  const std::string bytes = *BytesOf(tile_);
  EXPECT_EQ(bytes, *ReadTileBytes(TilePath(tile_)));
  EXPECT_EQ(*TileSize(tile_), static_cast<int64_t>(bytes.size()));
  const absl::Status otherwise = absl::DataLossError("other");
  EXPECT_TRUE(CheckTileFile(tile_, FileDigest(bytes), otherwise).ok());
  EXPECT_EQ(CheckTileFile(tile_, FileDigest("root"), otherwise), otherwise);
  EXPECT_TRUE(CheckFile(TilePath(tile_), FileDigest("root"), otherwise).ok());
  EXPECT_EQ(*SizeOfFile(TilePath(tile_)), 4);
}

TEST_F(CheckedFilesTest, WhatIsNotHereIsNotTheWorkersFault) {
  tile_.set_path("none/a.ply");
  for (const absl::Status& status :
       {TileSize(tile_).status(), SizeOfFile(TilePath(tile_)).status(), BytesOf(tile_).status(),
        CheckTileFile(tile_, FileDigest("x"), absl::DataLossError("")), CheckFile(TilePath(tile_), FileDigest("x"), {}),
        Changed(TilePath(tile_))}) {
    EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  }
}

}  // namespace
}  // namespace tilemend
