#include "common/store/blob_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

class BlobStoreTest : public testing::Test {
 protected:
  BlobStore Open() { return BlobStore::Open(folder_ / "blobs").value(); }
  TemporaryFolder folder_;
};

TEST_F(BlobStoreTest, ReturnsWhatWasPut) {
  const BlobStore store = Open();
  for (const std::string& bytes : {std::string(), std::string("a\0b", 3), std::string(3 << 20, 'x')}) {
    const std::string digest = store.Put(bytes).value();
    EXPECT_EQ(digest, Sha256Hex(bytes));
    EXPECT_EQ(store.Get(digest).value(), bytes);
  }
}

TEST_F(BlobStoreTest, PutsTheSameBytesOnce) {
  const BlobStore store = Open();
  const std::string digest = store.Put("abc").value();
  EXPECT_EQ(store.Put("abc").value(), digest);
  const std::filesystem::path fan(store.folder() + "/ba");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(fan), std::filesystem::directory_iterator()), 1);
  EXPECT_TRUE(std::filesystem::exists(fan / digest.substr(2)));
}

TEST_F(BlobStoreTest, KeepsBlobsWhenOpenedAgain) {
  const std::string digest = Open().Put("kept").value();
  EXPECT_EQ(Open().Get(digest).value(), "kept");
}

TEST_F(BlobStoreTest, RemovesAndForgets) {
  const BlobStore store = Open();
  const std::string digest = store.Put("abc").value();
  EXPECT_TRUE(store.Contains(digest).value());
  EXPECT_TRUE(store.Remove(digest).ok());
  EXPECT_FALSE(store.Contains(digest).value());
  EXPECT_EQ(store.Get(digest).status().code(), absl::StatusCode::kNotFound);
  EXPECT_TRUE(store.Remove(digest).ok()) << "removing what is not there is done already";
}

TEST_F(BlobStoreTest, NoticesDamageAndRepairsItOnThePut) {
  const BlobStore store = Open();
  const std::string digest = store.Put("abc").value();
  folder_.Write("blobs/" + digest.substr(0, 2) + "/" + digest.substr(2), "abd");
  EXPECT_EQ(store.Get(digest).status().code(), absl::StatusCode::kDataLoss);
  EXPECT_TRUE(store.Put("abc").ok());
  EXPECT_EQ(store.Get(digest).value(), "abc");
}

TEST_F(BlobStoreTest, RefusesNamesThatAreNoDigests) {
  const BlobStore store = Open();
  for (const std::string& name : {std::string("../../etc/passwd"), std::string(), std::string(64, 'g')}) {
    EXPECT_EQ(store.Get(name).status().code(), absl::StatusCode::kInvalidArgument) << name;
    EXPECT_EQ(store.Contains(name).status().code(), absl::StatusCode::kInvalidArgument) << name;
    EXPECT_EQ(store.Remove(name).code(), absl::StatusCode::kInvalidArgument) << name;
  }
}

TEST_F(BlobStoreTest, RefusesAFolderThatIsAFile) {
  const auto store = BlobStore::Open(folder_.Write("file", "x"));
  EXPECT_EQ(store.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(store.status().message()), HasSubstr("file: not a folder"));
}

TEST_F(BlobStoreTest, NamesThePathThatCannotBeUsed) {
  const auto store = BlobStore::Open(folder_.Write("file", "x") + "/below");
  EXPECT_THAT(std::string(store.status().message()), HasSubstr("file/below: "));
  const absl::Status forbidden = BlobStore::Open("/proc/tilemend").status();
  EXPECT_FALSE(forbidden.ok());
  EXPECT_THAT(std::string(forbidden.message()), HasSubstr("/proc/tilemend: "));
}

TEST_F(BlobStoreTest, SaysWhatStandsInABlobsPlace) {
  const BlobStore store = Open();
  const std::string digest = Sha256Hex("abc");
  folder_.Write("blobs/" + digest.substr(0, 2) + "/" + digest.substr(2) + "/inside", "x");  // a folder, not empty
  EXPECT_FALSE(store.Contains(digest).value());
  EXPECT_EQ(store.Get(digest).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(store.Remove(digest).code(), absl::StatusCode::kInternal);
  const std::string other = Sha256Hex("b");
  folder_.Write("blobs/" + other.substr(0, 2), "a file where a folder should be");
  EXPECT_FALSE(store.Contains(other).ok() && store.Contains(other).value());
  EXPECT_EQ(store.Put("b").status().code(), absl::StatusCode::kInvalidArgument);
}

TEST_F(BlobStoreTest, TakesPutsFromManyThreads) {
  const BlobStore store = Open();
  std::vector<std::string> digests(8);
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&store, &digests, t] {
      for (int i = 0; i < 50; ++i) digests[t] = store.Put("shared " + std::to_string(i)).value();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::count(digests.begin(), digests.end(), digests[0]), 8);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(store.Get(Sha256Hex("shared " + std::to_string(i))).ok()) << i;
}

}  // namespace
}  // namespace tilemend
