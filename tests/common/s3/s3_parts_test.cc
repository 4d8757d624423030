#include "common/s3/s3_parts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/s3/md5.h"
#include "tests/support/fake_s3.h"

namespace tilemend {
namespace {

std::string Md5Of(const std::string& bytes) {
  Md5 md5;
  md5.Update(bytes);
  return md5.FinishHex();
}

// A store that takes one upload, of parts of four bytes.
class S3PartsTest : public FakeS3 {
 protected:
  S3PartsTest() {
    part_bytes_ = 4;
    answers_ = [this](const httplib::Request& request, httplib::Response& answer) {
      answer.status = 200;
      const std::string part = request.get_param_value("partNumber");
      if (part == refused_) {
        answer.status = 403;
      } else if (!part.empty() && request.has_header("x-amz-copy-source")) {
        answer.set_content(absl::StrCat("<CopyPartResult><ETag>&quot;", Md5Of(part), "&quot;</ETag></CopyPartResult>"),
                           "application/xml");
      } else if (!part.empty()) {
        answer.set_header("ETag", absl::StrCat("\"", Md5Of(request.body), "\""));
      } else if (request.has_param("uploads")) {
        answer.set_content("<InitiateMultipartUploadResult><UploadId>up/1</UploadId></InitiateMultipartUploadResult>",
                           "application/xml");
      } else if (request.method == "POST") {
        Finish(request, answer);
      } else if (request.method == "HEAD" && !finished_.empty()) {
        answer.set_header("ETag", absl::StrCat("\"", ETagOfParts(), "\""));
      }
      return true;
    };
  }

  void Finish(const httplib::Request& request, httplib::Response& answer) {
    if (finished_.empty() && !refuses_to_finish_) finished_ = request.body;
    // The first answer is lost; the upload is not there any more.
    if (loses_answer_ || refuses_to_finish_) answer.status = tries_++ == 0 ? 503 : 404;
  }

  std::string ETagOfParts() const {
    std::string all;
    for (const char* part : {"1234", "5678", "9"}) all += absl::HexStringToBytes(Md5Of(part));
    return absl::StrCat(Md5Of(all), "-3");
  }

  std::vector<std::string> Asked() const {
    std::vector<std::string> asked;
    for (const httplib::Request& request : requests_)
      asked.push_back(absl::StrCat(request.method, " ", request.target));
    return asked;
  }

  std::string refused_ = "none", finished_;
  bool loses_answer_ = false, refuses_to_finish_ = false;
  int tries_ = 0;
};

TEST_F(S3PartsTest, SendsWhatIsLargerThanAPart) {
  ASSERT_TRUE(store_->Put("s3://city/a", "123456789").ok());
  EXPECT_EQ(Asked(),
            (std::vector<std::string>{"POST /city/a?uploads=", "PUT /city/a?partNumber=1&uploadId=up%2F1",
                                      "PUT /city/a?partNumber=2&uploadId=up%2F1",
                                      "PUT /city/a?partNumber=3&uploadId=up%2F1", "POST /city/a?uploadId=up%2F1"}));
  EXPECT_EQ(requests_[1].body, "1234");
  EXPECT_EQ(requests_[3].body, "9");
  EXPECT_EQ(finished_, absl::StrCat("<CompleteMultipartUpload><Part><PartNumber>1</PartNumber><ETag>\"", Md5Of("1234"),
                                    "\"</ETag></Part><Part><PartNumber>2</PartNumber><ETag>\"", Md5Of("5678"),
                                    "\"</ETag></Part><Part><PartNumber>3</PartNumber><ETag>\"", Md5Of("9"),
                                    "\"</ETag></Part></CompleteMultipartUpload>"));
}

TEST_F(S3PartsTest, SendsWhatIsAsLargeAsAPartAtOnce) {
  ASSERT_TRUE(store_->Put("s3://city/a", "1234").ok());
  EXPECT_EQ(Asked(), std::vector<std::string>{"PUT /city/a"});
}

TEST_F(S3PartsTest, TakesBackAnUploadThatFails) {
  refused_ = "2";
  const absl::Status status = store_->Put("s3://city/a", "123456789");
  EXPECT_TRUE(absl::IsPermissionDenied(status)) << status;
  EXPECT_EQ(Asked().back(), "DELETE /city/a?uploadId=up%2F1");
  EXPECT_EQ(finished_, "");
}

TEST_F(S3PartsTest, KnowsAFinishedUploadWhoseAnswerWasLost) {
  loses_answer_ = true;
  EXPECT_TRUE(store_->Put("s3://city/a", "123456789").ok());
  EXPECT_EQ(Asked().back(), "HEAD /city/a");
}

TEST_F(S3PartsTest, DoesNotTakeAnotherObjectForTheFinishedOne) {
  refuses_to_finish_ = true;
  EXPECT_FALSE(store_->Put("s3://city/a", "123456789").ok());
  EXPECT_EQ(Asked().back(), "DELETE /city/a?uploadId=up%2F1");
}

TEST_F(S3PartsTest, CopiesInPartsThatAreOfOneContent) {
  ASSERT_TRUE(store_->Copy("s3://city/a b", {9, "whole-9"}, "s3://city/b").ok());
  ASSERT_EQ(requests_.size(), 5U);
  for (size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(requests_[i].get_header_value("x-amz-copy-source"), "/city/a b");  // as it comes out of %20
    EXPECT_EQ(requests_[i].get_header_value("x-amz-copy-source-if-match"), "whole-9");
  }
  EXPECT_EQ(requests_[1].get_header_value("x-amz-copy-source-range"), "bytes=0-3");
  EXPECT_EQ(requests_[3].get_header_value("x-amz-copy-source-range"), "bytes=8-8");
  EXPECT_NE(finished_.find(Md5Of("3")), std::string::npos);
}

TEST(S3PartBytesTest, GrowsWhereThereWouldBeTooManyParts) {
  constexpr int64_t kMebibyte = 1 << 20;
  EXPECT_EQ(PartBytes(100 * kMebibyte, 64 * kMebibyte), 64 * kMebibyte);
  const int64_t large = PartBytes(5000000 * kMebibyte, 64 * kMebibyte);
  EXPECT_EQ(large, 500 * kMebibyte);
  EXPECT_EQ(PartBytes(large * 10000 + 1, 64 * kMebibyte), large + 1);
}

}  // namespace
}  // namespace tilemend
