#include "common/s3/s3_store.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/fake_s3.h"

namespace tilemend {
namespace {

using S3StoreTest = FakeS3;

TEST_F(S3StoreTest, ReadsOnceWhatDoesNotChange) {
  for (int i = 0; i < 2; ++i) {
    const auto file = store_->Open("s3://city/a");
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(TextOf(*file), "hello");
  }
  EXPECT_EQ(requests_.size(), 3U);             // HEAD, GET, HEAD
  etag_ = "7d793037a0760186574b0282f2f435e7";  // of "world"
  content_ = "world";
  EXPECT_EQ(TextOf(*store_->Open("s3://city/a")), "world");
}

TEST_F(S3StoreTest, RemovesWhatIsNotThere) {
  failures_ = 1;
  failure_ = 404;
  EXPECT_TRUE(store_->Remove("s3://city/a").ok());
}

TEST_F(S3StoreTest, SeesAnErrorInASuccess) {
  content_ = "<Error><Code>InternalError</Code></Error>";
  EXPECT_TRUE(absl::IsUnavailable(store_->Copy("s3://city/a", {5, kHelloMd5}, "s3://city/b")));
  EXPECT_EQ(requests_.back().get_header_value("x-amz-copy-source"), "/city/a");
}

TEST_F(S3StoreTest, ListsPageByPage) {
  content_ =
      "<ListBucketResult><Contents><Key>out/b</Key></Contents><CommonPrefixes><Prefix>out/a/</Prefix></CommonPrefixes>"
      "</ListBucketResult>";
  const auto entries = store_->List("s3://city/out");
  ASSERT_TRUE(entries.ok()) << entries.status();
  ASSERT_EQ(entries->size(), 2U);
  EXPECT_EQ(entries->front().name, "a");
  EXPECT_TRUE(entries->front().is_folder);
  EXPECT_EQ(requests_.back().target, "/city?delimiter=%2F&list-type=2&prefix=out%2F");
}

TEST_F(S3StoreTest, KnowsAnEmptyFolderFromAnEmptyBucket) {
  content_ = "<ListBucketResult/>";
  EXPECT_TRUE(absl::IsNotFound(store_->List("s3://city/out").status()));
  EXPECT_TRUE(store_->List("s3://city").ok());
}

TEST_F(S3StoreTest, AsksWhyAHeadIsRefused) {
  failures_ = 10;
  failure_ = 403;
  failure_text_ = "<Error><Code>RequestTimeTooSkewed</Code></Error>";
  const absl::Status status = store_->Look("s3://city/a").status();
  EXPECT_TRUE(absl::IsPermissionDenied(status));
  EXPECT_NE(std::string(status.message()).find("set the clock"), std::string::npos) << status;
  failure_ = 400;
  failure_text_ = "<Error><Code>ExpiredToken</Code></Error>";
  const absl::Status expired = store_->Look("s3://city/a").status();
  EXPECT_NE(std::string(expired.message()).find("renew the credentials"), std::string::npos) << expired;
}

}  // namespace
}  // namespace tilemend
