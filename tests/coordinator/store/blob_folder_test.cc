#include "coordinator/store/blob_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/failpoint.h"
#include "common/util/files.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

int64_t FilesIn(const std::string& folder) {
  const fs::recursive_directory_iterator all(folder);
  return std::count_if(begin(all), end(all), [](const fs::directory_entry& entry) { return entry.is_regular_file(); });
}

std::string HoldBytes(BlobFolder& blobs, std::string bytes) {
  std::string digest = Sha256Hex(bytes);
  EXPECT_TRUE(blobs.Hold(digest, [&bytes] { return std::move(bytes); }).ok());
  return digest;
}

class BlobFolderTest : public ::testing::Test {
 protected:
  TempFolder folder_;
  std::shared_ptr<BlobFolder> blobs_ = *BlobFolder::Create(folder_ / "blobs");
};

TEST_F(BlobFolderTest, GivesBackWhatWasPut) {
  for (const size_t size : {size_t{0}, size_t{1}, kMaxChunkBytes, kMaxChunkBytes + 1, 5 * kMaxChunkBytes}) {
    const std::string bytes(size, static_cast<char>('a' + size % 7));
    const auto digest = blobs_->Put(bytes);
    ASSERT_TRUE(digest.ok()) << digest.status();
    EXPECT_EQ(*digest, Sha256Hex(bytes));
    EXPECT_EQ(*blobs_->Size(*digest), static_cast<int64_t>(size));
    EXPECT_TRUE(*blobs_->Read(*digest) == bytes);
  }
}

TEST_F(BlobFolderTest, GivesNoDamagedBytes) {
  const std::string digest = *blobs_->Put("hello");
  const std::string path = folder_ / ("blobs/" + digest.substr(0, 1) + "/" + digest.substr(1));
  for (const char* damaged : {"hell", "Hello", ""}) {
    ASSERT_TRUE(WriteFileAtomically(path, damaged).ok());
    EXPECT_EQ(ErrorReason(blobs_->Read(digest).status()), "BLOB_DAMAGED");
  }
}

TEST_F(BlobFolderTest, HoldsBlobsInMemoryUntilEachHolderLetsGo) {
  const std::string bytes(kMaxChunkBytes + 5, 'h');
  const std::string digest = HoldBytes(*blobs_, bytes);
  EXPECT_EQ(digest, Sha256Hex(bytes));
  EXPECT_EQ(HoldBytes(*blobs_, bytes), digest);
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 0);
  blobs_->LetGo(digest);
  EXPECT_EQ(*blobs_->Size(digest), static_cast<int64_t>(bytes.size()));
  EXPECT_TRUE(*blobs_->Read(digest) == bytes);
  std::vector<size_t> chunks;
  const auto take = [&](std::string_view chunk) {
    chunks.push_back(chunk.size());
    return true;
  };
  EXPECT_TRUE(blobs_->ReadChunks(digest, take).ok());
  EXPECT_EQ(chunks, (std::vector<size_t>{kMaxChunkBytes, 5}));
  blobs_->LetGo(digest);
  blobs_->LetGo(digest);
  EXPECT_EQ(ErrorReason(blobs_->Read(digest).status()), "BLOB_NOT_FOUND");
}

TEST_F(BlobFolderTest, ReadsWhatItIsToHoldOnlyIfItIsNotThere) {
  const std::string bytes = "a part", digest = Sha256Hex(bytes);
  int reads = 0;
  const auto read = [&]() -> absl::StatusOr<std::string> {
    ++reads;
    return bytes;
  };
  EXPECT_TRUE(blobs_->Hold(digest, read).ok());
  EXPECT_TRUE(blobs_->Hold(digest, read).ok());
  EXPECT_EQ(reads, 1);
  EXPECT_EQ(blobs_->Read(digest).value(), bytes);
  blobs_->LetGo(digest);
  EXPECT_TRUE(blobs_->Size(digest).ok());
  blobs_->LetGo(digest);
  EXPECT_TRUE(absl::IsNotFound(blobs_->Size(digest).status()));
}

TEST_F(BlobFolderTest, HoldsNoMoreInMemoryThanAllFoldersMay) {
  const auto other = *BlobFolder::Create(folder_ / "other");
  const std::string first = HoldBytes(*other, std::string(kMostHeldBytes - 10, 'a'));
  const std::string second = HoldBytes(*blobs_, std::string(11, 'b'));
  EXPECT_EQ(FilesIn(folder_ / "other"), 0);
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 1) << "more than the process may hold";
  EXPECT_EQ(*blobs_->Read(second), std::string(11, 'b'));
  HoldBytes(*blobs_, std::string(10, 'c'));
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 1);
  blobs_->LetGo(second);
  EXPECT_TRUE(blobs_->Read(second).ok()) << "a file stays as long as its folder";
  other->Remove();
  HoldBytes(*blobs_, std::string(kMostHeldBytes - 10, 'd'));
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 1) << "what a folder held is free when that goes";
}

TEST_F(BlobFolderTest, IsHeldInOnePlaceWhoeverHoldsIt) {
  const auto other = *BlobFolder::Create(folder_ / "other");
  HoldBytes(*other, std::string(kMostHeldBytes, 'a'));
  const std::string digest = HoldBytes(*blobs_, "in a file");
  other->Remove();
  ASSERT_EQ(HoldBytes(*blobs_, "in a file"), digest) << "there is memory now";
  HoldBytes(*blobs_, std::string(kMostHeldBytes, 'b'));
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 1) << "the second time it took no memory";
  blobs_->LetGo(digest);
  EXPECT_EQ(*blobs_->Read(digest), "in a file");
}

TEST_F(BlobFolderTest, ReadsInChunksOfAtMostOneMiB) {
  const std::string digest = *blobs_->Put(std::string(5'000'000, 'x'));
  size_t total = 0;
  size_t largest = 0;
  EXPECT_TRUE(blobs_
                  ->ReadChunks(digest,
                               [&](std::string_view chunk) {
                                 total += chunk.size();
                                 largest = std::max(largest, chunk.size());
                                 return true;
                               })
                  .ok());
  EXPECT_EQ(total, 5'000'000U);
  EXPECT_LE(largest, kMaxChunkBytes);
}

TEST_F(BlobFolderTest, RefusesBytesOfAnotherDigestAndLeavesNothing) {
  {
    const auto writer = *blobs_->NewWriter();
    ASSERT_TRUE(writer->Append("hello").ok());
    EXPECT_EQ(ErrorReason(writer->Commit(Sha256Hex("other")).status()), "BLOB_CORRUPT");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "blobs"));
}

TEST_F(BlobFolderTest, TwoThatWriteIntoOneFolderDoNotMeet) {
  BlobFolder other(folder_ / "blobs");  // of a coordinator that was stopped and has not yet found itself replaced
  const auto first = *blobs_->NewWriter();
  const auto second = other.NewWriter();
  ASSERT_TRUE(second.ok()) << second.status();
  ASSERT_TRUE(first->Append("a").ok());
  ASSERT_TRUE((*second)->Append("b").ok());
  EXPECT_TRUE(first->Commit(Sha256Hex("a")).ok());
  EXPECT_TRUE((*second)->Commit(Sha256Hex("b")).ok());
  EXPECT_EQ(*blobs_->Read(Sha256Hex("b")), "b");
}

TEST_F(BlobFolderTest, RefusesNamesThatAreNoDigests) {
  EXPECT_TRUE(absl::IsInvalidArgument(blobs_->Read("../../etc/passwd").status()));
  EXPECT_TRUE(absl::IsInvalidArgument(blobs_->Read(std::string(64, 'A')).status()));
  EXPECT_EQ(ErrorReason(blobs_->Read(std::string(64, 'a')).status()), "BLOB_NOT_FOUND");
}

TEST_F(BlobFolderTest, IsGoneAfterRemove) {
  const auto writer = *blobs_->NewWriter();
  ASSERT_TRUE(writer->Append("late").ok());
  const std::string digest = *blobs_->Put("hello");
  blobs_->Remove();
  EXPECT_FALSE(writer->Commit(Sha256Hex("late")).ok());
  EXPECT_FALSE(blobs_->Put("more").ok());
  EXPECT_FALSE(blobs_->Read(digest).ok());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "blobs"));
}

TEST_F(BlobFolderTest, RemoveStopsWhereItIsTold) {
  for (const char* bytes : {"a", "b", "c", "d"}) ASSERT_TRUE(blobs_->Put(bytes).ok());
  int asked = 0;
  blobs_->Remove([&] { return ++asked > 2; });
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 2);
  EXPECT_FALSE(blobs_->Put("more").ok());
}

TEST_F(BlobFolderTest, KeepsOnlyWhatIsStillNeeded) {
  const std::string kept = *blobs_->Put("kept"), other = *blobs_->Put("other");
  ASSERT_TRUE(WriteFileAtomically(folder_ / "blobs/part-abcdef", "half").ok());
  ASSERT_TRUE(blobs_->KeepOnly({kept, Sha256Hex("lost")}).ok());
  EXPECT_EQ(*blobs_->Read(kept), "kept");
  EXPECT_FALSE(blobs_->Read(other).ok());
  EXPECT_EQ(FilesIn(folder_ / "blobs"), 1);
  for (const auto& beside : fs::directory_iterator(folder_ / "")) {
    if (beside.path().filename() == "blobs") continue;
    EXPECT_TRUE(beside.path().filename().string().starts_with("blobs.")) << beside;
    fs::remove_all(beside.path());  // as the sweep does
  }
  EXPECT_EQ(*blobs_->Read(kept), "kept");
  EXPECT_EQ(*blobs_->Put("other"), other) << "may be put again";
  EXPECT_EQ(*blobs_->Read(other), "other");
}

// The name of a blob is on the disk if those of the folders above it are.
TEST_F(BlobFolderTest, SyncsTheFolderOfAParentOnceForEachDigit) {
  const absl::Cleanup disarm = [] { ArmFailPoint("").IgnoreError(); };
  const auto syncs_all = [&](const std::string& bytes) {
    EXPECT_TRUE(ArmFailPoint("blob.parent:1:error").ok());  // the sync that may be left out fails
    const bool is_left_out = blobs_->Put(bytes, Sync::kYes).ok();
    EXPECT_TRUE(ArmFailPoint("").ok());
    return !is_left_out;
  };
  const std::string first = "0", same_digit = "23", other_digit = "1";
  ASSERT_EQ(Sha256Hex(first)[0], Sha256Hex(same_digit)[0]);
  ASSERT_NE(Sha256Hex(first)[0], Sha256Hex(other_digit)[0]);
  EXPECT_TRUE(syncs_all(first));
  EXPECT_TRUE(syncs_all(first)) << "the first time it failed";
  ASSERT_TRUE(blobs_->Put(first, Sync::kYes).ok());
  EXPECT_FALSE(syncs_all(same_digit));
  EXPECT_TRUE(syncs_all(other_digit));
  ASSERT_TRUE(blobs_->KeepOnly({}).ok());
  EXPECT_TRUE(syncs_all(first)) << "in a new folder";
}

// The empty string, "abc": FIPS 180-4.
TEST(DigestTest, KnownAnswers) {
  EXPECT_EQ(Sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

}  // namespace
}  // namespace tilemend
