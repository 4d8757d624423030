#include "common/s3/s3_requests.h"

#include <gtest/gtest.h>

#include <string>

#include "absl/strings/match.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/support/fake_s3.h"

namespace tilemend {
namespace {

using S3RequestsTest = FakeS3;

TEST_F(S3RequestsTest, SignsWhatItPuts) {
  ASSERT_TRUE(store_->Put("s3://city/a+b", "hello").ok());
  ASSERT_EQ(requests_.size(), 1U);
  const httplib::Request& request = requests_[0];
  EXPECT_EQ(request.body, "hello");
  EXPECT_EQ(request.target, "/city/a%2Bb");
  EXPECT_EQ(request.get_header_value("x-amz-content-sha256"), Sha256Hex("hello"));
  const std::string signature = request.get_header_value("Authorization");
  EXPECT_TRUE(absl::StartsWith(signature, "AWS4-HMAC-SHA256 Credential=key-id/")) << signature;
  EXPECT_TRUE(absl::StrContains(signature, "/eu-north-1/s3/aws4_request")) << signature;
  EXPECT_TRUE(absl::StrContains(signature, "x-amz-content-sha256")) << signature;
}

TEST_F(S3RequestsTest, TriesAgain) {
  failures_ = 2;
  const auto look = store_->Look("s3://city/a");
  ASSERT_TRUE(look.ok()) << look.status();
  EXPECT_EQ(look->size, 5);
  EXPECT_EQ(look->etag, kHelloMd5);
  EXPECT_EQ(requests_.size(), 3U);
}

TEST_F(S3RequestsTest, GivesUpInTheEnd) {
  failures_ = 100;
  failure_text_ = "<Error><Code>SlowDown</Code></Error>";
  const absl::Status status = store_->Put("s3://city/a", "hello");
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OBJECT_STORE_UNREACHABLE");
  EXPECT_EQ(status.message(), "s3://city/a: the object store answers HTTP 503 SlowDown (3 tries)");
  EXPECT_EQ(requests_.size(), 3U);
}

TEST_F(S3RequestsTest, DoesNotTryAgainWhatIsRefused) {
  failures_ = 100;
  failure_ = 403;
  failure_text_ = "<Error><Code>SignatureDoesNotMatch</Code><Message>key-id</Message></Error>";
  const absl::Status status = store_->List("s3://city/a").status();
  EXPECT_TRUE(absl::IsPermissionDenied(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OBJECT_STORE_REFUSED");
  EXPECT_TRUE(absl::StrContains(std::string(status.message()), "s3://city/a: the object store refuses it: HTTP 403"));
  for (const char* hidden : {kFakeSecret, "key-id"}) {
    EXPECT_FALSE(absl::StrContains(std::string(status.message()), hidden)) << status;
  }
  EXPECT_EQ(requests_.size(), 1U);
}

TEST_F(S3RequestsTest, TellsAMissingBucketFromAMissingObject) {
  failures_ = 2;
  failure_ = 404;
  failure_text_ = "<Error><Code>NoSuchBucket</Code></Error>";
  EXPECT_EQ(store_->List("s3://city/a").status().message(), "s3://city/a: no such bucket");
  failure_text_ = "<Error><Code>NoSuchKey</Code></Error>";
  EXPECT_EQ(store_->Put("s3://city/a", "hello").message(), "s3://city/a: no such object");
}

TEST_F(S3RequestsTest, RefusesOtherBytesThanTheChecksumSays) {
  content_ = "hellp";
  const absl::Status read = store_->Open("s3://city/a").status();
  EXPECT_TRUE(absl::IsUnavailable(read)) << read;
  EXPECT_TRUE(absl::StrContains(std::string(read.message()), "checksum")) << read;
  const absl::Status written = store_->Put("s3://city/a", "hellp");
  EXPECT_TRUE(absl::StrContains(std::string(written.message()), "has other bytes than were sent")) << written;
}

TEST_F(S3RequestsTest, TakesAnEtagInPartsForNoChecksum) {
  etag_ = std::string(kHelloMd5) + "-2";
  content_ = "parts";
  const auto file = store_->Open("s3://city/a");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(TextOf(*file), "parts");
}

// Some stores answer 200 before they copy.
}  // namespace
}  // namespace tilemend
