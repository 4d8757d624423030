#include "common/store/file_receipt.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class FileReceiptTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_.Write("a", "bytes");
};

TEST_F(FileReceiptTest, StaysWhenTheFileIsRenamedOrLinked) {
  const FileReceipt receipt = ReceiptOf(path_).value();
  EXPECT_EQ(receipt.bytes, 5);
  std::filesystem::create_hard_link(path_, folder_ / "link");
  std::filesystem::rename(path_, folder_ / "b");
  EXPECT_EQ(ReceiptOf(folder_ / "b").value(), receipt);
  EXPECT_EQ(ReceiptOf(folder_ / "link").value(), receipt);
}

TEST_F(FileReceiptTest, IsAnotherForAnotherFileAndAfterAChange) {
  const FileReceipt receipt = ReceiptOf(path_).value();
  EXPECT_NE(ReceiptOf(folder_.Write("b", "bytes")).value(), receipt);
  std::filesystem::last_write_time(path_, std::filesystem::last_write_time(path_) + std::chrono::nanoseconds(1));
  EXPECT_NE(ReceiptOf(path_).value(), receipt);
}

TEST_F(FileReceiptTest, OnlyRegularFilesHaveOne) {
  EXPECT_TRUE(absl::IsNotFound(ReceiptOf(folder_ / "none").status()));
  EXPECT_TRUE(absl::IsNotFound(ReceiptOf(folder_.path()).status()));
  std::filesystem::create_symlink(path_, folder_ / "link");
  EXPECT_FALSE(ReceiptOf(folder_ / "link").ok());
}

TEST_F(FileReceiptTest, ComesWithTheDigestOfWhatWasRead) {
  const ReadReceipt read = ReadForReceipt(path_).value();
  EXPECT_EQ(read.digest, FileDigest("bytes"));
  EXPECT_EQ(read.receipt, ReceiptOf(path_).value());
  EXPECT_FALSE(ReadForReceipt(folder_ / "none").ok());
}

}  // namespace
}  // namespace tilemend
