#include "common/s3/s3_store.h"

#include <gtest/gtest.h>
#include <httplib.h>
#include <unistd.h>

#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "absl/strings/match.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"

namespace tilemend {
namespace {

constexpr char kSecret[] = "very-secret";
constexpr char kHelloMd5[] = "5d41402abc4b2a76b9719d911017c592";  // of "hello"

// A store that answers as it is told. What it is asked is kept.
class S3StoreTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto handle = [this](const httplib::Request& request, httplib::Response& answer) {
      const std::lock_guard lock(mutex_);
      requests_.push_back(request);
      answer.status = failures_-- > 0 ? failure_ : 200;
      if (answer.status != 200) return answer.set_content(failure_text_, "application/xml");
      answer.set_header("ETag", "\"" + etag_ + "\"");
      answer.set_content(content_, "application/octet-stream");
    };
    server_.Get(".*", handle);
    server_.Put(".*", handle);
    server_.Delete(".*", handle);
    port_ = server_.bind_to_any_port("127.0.0.1");
    serving_ = std::thread([this] { server_.listen_after_bind(); });
    values_ = {{"AWS_ENDPOINT_URL", "http://127.0.0.1:" + std::to_string(port_)}, {"AWS_ACCESS_KEY_ID", "key-id"},
               {"AWS_SECRET_ACCESS_KEY", kSecret}, {"AWS_REGION", "eu-north-1"}};
    store_ = NewS3Store(
        [this](const char* name) {
          const auto found = values_.find(name);
          return found == values_.end() ? nullptr : found->second.c_str();
        },
        1000, {3, absl::Milliseconds(1)});
  }
  void TearDown() override {
    server_.stop();
    serving_.join();
  }
  std::string TextOf(int file) {
    char text[64];
    const ssize_t size = ::pread(file, text, sizeof(text), 0);
    ::close(file);
    return {text, static_cast<size_t>(std::max<ssize_t>(size, 0))};
  }

  httplib::Server server_;
  int port_ = 0;
  std::thread serving_;
  std::mutex mutex_;
  std::vector<httplib::Request> requests_;
  int failures_ = 0, failure_ = 503;
  std::string failure_text_, etag_ = kHelloMd5, content_ = "hello";
  std::map<std::string, std::string> values_;
  std::unique_ptr<ObjectStore> store_;
};

TEST_F(S3StoreTest, SignsWhatItPuts) {
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

TEST_F(S3StoreTest, ReadsOnceWhatDoesNotChange) {
  for (int i = 0; i < 2; ++i) {
    const auto file = store_->Open("s3://city/a");
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_EQ(TextOf(*file), "hello");
  }
  EXPECT_EQ(requests_.size(), 3U);  // HEAD, GET, HEAD
  etag_ = "7d793037a0760186574b0282f2f435e7";  // of "world"
  content_ = "world";
  EXPECT_EQ(TextOf(*store_->Open("s3://city/a")), "world");
}

TEST_F(S3StoreTest, TriesAgain) {
  failures_ = 2;
  const auto look = store_->Look("s3://city/a");
  ASSERT_TRUE(look.ok()) << look.status();
  EXPECT_EQ(look->size, 5);
  EXPECT_EQ(look->etag, kHelloMd5);
  EXPECT_EQ(requests_.size(), 3U);
}

TEST_F(S3StoreTest, GivesUpInTheEnd) {
  failures_ = 100;
  failure_text_ = "<Error><Code>SlowDown</Code></Error>";
  const absl::Status status = store_->Put("s3://city/a", "hello");
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OBJECT_STORE_UNREACHABLE");
  EXPECT_EQ(status.message(), "s3://city/a: the object store answers HTTP 503 SlowDown (3 tries)");
  EXPECT_EQ(requests_.size(), 3U);
}

TEST_F(S3StoreTest, DoesNotTryAgainWhatIsRefused) {
  failures_ = 100;
  failure_ = 403;
  failure_text_ = "<Error><Code>SignatureDoesNotMatch</Code><Message>key-id</Message></Error>";
  const absl::Status status = store_->List("s3://city/a").status();
  EXPECT_TRUE(absl::IsPermissionDenied(status)) << status;
  EXPECT_EQ(ErrorReason(status), "OBJECT_STORE_REFUSED");
  EXPECT_TRUE(absl::StrContains(std::string(status.message()), "s3://city/a: the object store refuses it: HTTP 403"));
  for (const char* hidden : {kSecret, "key-id"}) {
    EXPECT_FALSE(absl::StrContains(std::string(status.message()), hidden)) << status;
  }
  EXPECT_EQ(requests_.size(), 1U);
}

TEST_F(S3StoreTest, TellsAMissingBucketFromAMissingObject) {
  failures_ = 2;
  failure_ = 404;
  failure_text_ = "<Error><Code>NoSuchBucket</Code></Error>";
  EXPECT_EQ(store_->List("s3://city/a").status().message(), "s3://city/a: no such bucket");
  failure_text_ = "<Error><Code>NoSuchKey</Code></Error>";
  EXPECT_EQ(store_->Put("s3://city/a", "hello").message(), "s3://city/a: no such object");
}

TEST_F(S3StoreTest, RefusesOtherBytesThanTheChecksumSays) {
  content_ = "hellp";
  const absl::Status read = store_->Open("s3://city/a").status();
  EXPECT_TRUE(absl::IsUnavailable(read)) << read;
  EXPECT_TRUE(absl::StrContains(std::string(read.message()), "checksum")) << read;
  const absl::Status written = store_->Put("s3://city/a", "hellp");
  EXPECT_TRUE(absl::StrContains(std::string(written.message()), "has other bytes than were sent")) << written;
}

TEST_F(S3StoreTest, TakesAnEtagInPartsForNoChecksum) {
  etag_ = std::string(kHelloMd5) + "-2";
  content_ = "parts";
  const auto file = store_->Open("s3://city/a");
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(TextOf(*file), "parts");
}

TEST_F(S3StoreTest, RemovesWhatIsNotThere) {
  failures_ = 1;
  failure_ = 404;
  EXPECT_TRUE(store_->Remove("s3://city/a").ok());
}

// Some stores answer 200 before they copy.
TEST_F(S3StoreTest, SeesAnErrorInASuccess) {
  content_ = "<Error><Code>InternalError</Code></Error>";
  EXPECT_TRUE(absl::IsUnavailable(store_->Copy("s3://city/a", "s3://city/b")));
  EXPECT_EQ(requests_.back().get_header_value("x-amz-copy-source"), "/city/a");
}

}  // namespace
}  // namespace tilemend
