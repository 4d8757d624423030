#include "worker/materials/file_witness.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class FileWitnessTest : public ::testing::Test {
 protected:
  FileWitnessTest() {
    folder_.Write("Data/a.mtl", "newmtl a");
    witness_.lookups.push_back({"Data", "A.mtl", "Data/a.mtl", ""});
    witness_.lookups.push_back({"Data", "b.jpg", "", "is not there"});
    witness_.reads.push_back({"Data/a.mtl", FileDigest("newmtl a")});
    witness_.reads.push_back({"Data/b.jpg", ""});
  }

  const TemporaryFolder folder_;
  FileWitness witness_;
};

TEST_F(FileWitnessTest, HoldsWhileNothingChanges) {
  EXPECT_TRUE(Holds(folder_.path(), witness_));
  folder_.Write("Data/a.mtl", "newmtl a");
  EXPECT_TRUE(Holds(folder_.path(), witness_)) << "written anew as it was";
}

TEST_F(FileWitnessTest, SeesOtherBytesOfTheSameSize) {
  folder_.Write("Data/a.mtl", "newmtl b");
  EXPECT_FALSE(Holds(folder_.path(), witness_));
}

TEST_F(FileWitnessTest, SeesAFileThatWasMissing) {
  folder_.Write("Data/b.jpg", "");
  EXPECT_FALSE(Holds(folder_.path(), witness_));
}

TEST_F(FileWitnessTest, SeesANameThatLeadsElsewhereNow) {
  folder_.Write("Data/A.mtl", "newmtl a");
  EXPECT_FALSE(Holds(folder_.path(), witness_));
}

TEST_F(FileWitnessTest, SeesAFileThatIsGone) {
  std::filesystem::remove(folder_ / "Data/a.mtl");
  EXPECT_FALSE(Holds(folder_.path(), witness_));
}

TEST_F(FileWitnessTest, HoldsForAFolderOfTilesThatIsALink) {
  const TemporaryFolder scene;
  std::filesystem::create_directory_symlink(folder_ / "Data", scene / "Data");
  EXPECT_TRUE(Holds(scene.path(), witness_));
}

TEST_F(FileWitnessTest, ReadsNothingOutsideOfTheScene) {
  const std::string other = folder_.Write("other", "x");
  EXPECT_FALSE(Holds(folder_ / "Data", {{}, {{"../other", FileDigest("x")}}}));
  EXPECT_FALSE(Holds(folder_ / "Data", {{}, {{other, FileDigest("x")}}}));
}

}  // namespace
}  // namespace tilemend
