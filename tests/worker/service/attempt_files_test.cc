#include "worker/service/attempt_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class AttemptFilesTest : public testing::Test {
 protected:
  AttemptFilesTest() {
    std::filesystem::create_directory(attempts_);
    folder_.Write("scene/a.png", "image");
  }
  bool IsEmpty() const { return std::filesystem::is_empty(attempts_); }
  std::string Content(const v1::WrittenFile& file) const {
    return ReadFile(attempts_ + "/" + file.attempt()).value_or("none");
  }

  const TemporaryFolder folder_;
  const std::string attempts_ = folder_ / "attempts", out_ = folder_ / "out";
};

TEST_F(AttemptFilesTest, SaysWhatItWroteTheLastFirst) {
  AttemptFiles files(attempts_, out_);
  ASSERT_TRUE(files.Carry(folder_ / "scene/a.png", "a.png", Carry::kCopy).ok());
  EXPECT_TRUE(files.LastHas(FileDigest("image")));
  EXPECT_FALSE(files.LastHas(FileDigest("another")));
  ASSERT_TRUE(files.Write("tiles/a.ply", "tile").ok());
  const auto written = files.Keep();
  ASSERT_EQ(written.size(), 2U);
  EXPECT_EQ(written[0].path(), "tiles/a.ply");
  EXPECT_EQ(written[0].bytes(), 4);
  EXPECT_EQ(written[0].digest(), FileDigest("tile"));
  EXPECT_EQ(Content(written[0]), "tile");
  EXPECT_EQ(written[1].path(), "a.png");
  EXPECT_EQ(written[1].bytes(), 5);
  EXPECT_EQ(Content(written[1]), "image");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(AttemptFilesTest, TakesBackWhatIsNotKept) {
  {
    AttemptFiles files(attempts_, out_);
    ASSERT_TRUE(files.Write("a", "tile").ok());
    EXPECT_FALSE(IsEmpty());
  }
  EXPECT_TRUE(IsEmpty());
}

TEST_F(AttemptFilesTest, WhatWasKeptForAResultThatNobodyWantsGoes) {
  AttemptFiles files(attempts_, out_);
  ASSERT_TRUE(files.Write("a", "tile").ok());
  v1::AssembleInput input;
  input.set_attempts(attempts_);
  v1::AssembleOutput output;
  for (const v1::WrittenFile& file : files.Keep()) *output.add_files() = file;
  output.set_unchanged(true);  // the files are those of an earlier job
  RemoveKept(Stage::kAssemble, input.SerializeAsString(), output.SerializeAsString());
  EXPECT_FALSE(IsEmpty());
  output.set_unchanged(false);
  RemoveKept(Stage::kFill, input.SerializeAsString(), output.SerializeAsString());
  EXPECT_FALSE(IsEmpty());
  RemoveKept(Stage::kAssemble, input.SerializeAsString(), output.SerializeAsString());
  EXPECT_TRUE(IsEmpty());
}

TEST_F(AttemptFilesTest, TwoAttemptsNeverMeet) {
  AttemptFiles one(attempts_, out_), other(attempts_, out_);
  ASSERT_TRUE(one.Write("a", "old").ok());
  ASSERT_TRUE(other.Write("a", "new").ok());
  EXPECT_EQ(Content(one.Keep()[0]), "old");
  EXPECT_EQ(Content(other.Keep()[0]), "new");
}

TEST_F(AttemptFilesTest, AfterTheJobItCanWriteNowhere) {
  AttemptFiles files(attempts_, out_);
  std::filesystem::remove_all(attempts_);
  for (const absl::Status& status :
       {files.Write("a", "late"), files.Carry(folder_ / "scene/a.png", "a.png", Carry::kCopy),
        files.Carry(folder_ / "scene/a.png", "a.png", Carry::kLink)}) {
    EXPECT_TRUE(absl::IsUnavailable(status)) << status;
    EXPECT_EQ(ErrorReason(status), "FOLDER_NOT_SEEN");
  }
  EXPECT_FALSE(std::filesystem::exists(attempts_));
}

TEST_F(AttemptFilesTest, ALinkToTheFileIsReplaced) {
  std::filesystem::create_directory(out_);
  std::filesystem::create_symlink(folder_ / "scene/a.png", out_ + "/a.png");
  AttemptFiles files(attempts_, out_);
  EXPECT_TRUE(files.Carry(folder_ / "scene/a.png", "a.png", Carry::kCopy).ok());
}

TEST_F(AttemptFilesTest, AFileIsNotCarriedOntoItself) {
  std::filesystem::create_directory_symlink(folder_ / "scene", out_);
  AttemptFiles files(attempts_, out_);
  EXPECT_TRUE(absl::IsInvalidArgument(files.Carry(folder_ / "scene/a.png", "a.png", Carry::kCopy)));
  EXPECT_TRUE(absl::IsNotFound(files.Carry(folder_ / "scene/none", "other", Carry::kCopy)));
  EXPECT_TRUE(IsEmpty());
}

}  // namespace
}  // namespace tilemend
