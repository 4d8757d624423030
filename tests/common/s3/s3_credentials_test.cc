#include "common/s3/s3_credentials.h"

#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <map>
#include <string>
#include <thread>

#include "absl/time/clock.h"
#include "common/util/error_info.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class S3CredentialsTest : public testing::Test {
 protected:
  S3CredentialSource Source() {
    values_["AWS_EC2_METADATA_DISABLED"] = imds_ ? "false" : "true";
    return S3CredentialSource([this](const char* name) {
      const auto found = values_.find(name);
      return found == values_.end() ? nullptr : found->second.c_str();
    });
  }
  void WriteFile(const std::string& text) {
    values_["AWS_SHARED_CREDENTIALS_FILE"] = folder_.Write("credentials", text);
  }

  TemporaryFolder folder_;
  std::map<std::string, std::string> values_;
  bool imds_ = false;
};

TEST_F(S3CredentialsTest, TakesTheEnvironmentFirst) {
  WriteFile("[default]\naws_access_key_id=file\naws_secret_access_key=s\n");
  values_["AWS_ACCESS_KEY_ID"] = "given";
  values_["AWS_SECRET_ACCESS_KEY"] = "secret";
  values_["AWS_SESSION_TOKEN"] = "token";
  auto source = Source();
  const auto found = source.Get(absl::Now());
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->key_id, "given");
  EXPECT_EQ(found->session_token, "token");
}

TEST_F(S3CredentialsTest, TakesTheProfileOfAFile) {
  WriteFile(
      "# mine\n[default]\naws_access_key_id=a\naws_secret_access_key=b\n[city]\naws_access_key_id = c\n"
      "aws_secret_access_key = d=e\n");
  values_["AWS_PROFILE"] = "city";
  auto source = Source();
  const auto found = source.Get(absl::Now());
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->key_id, "c");
  EXPECT_EQ(found->secret, "d=e");
}

TEST_F(S3CredentialsTest, ReadsAFileAgainAfterAMinute) {
  WriteFile("[default]\naws_access_key_id=old\naws_secret_access_key=s\n");
  auto source = Source();
  const absl::Time now = absl::Now();
  ASSERT_EQ(source.Get(now)->key_id, "old");
  WriteFile("[default]\naws_access_key_id=new\naws_secret_access_key=s\n");
  EXPECT_EQ(source.Get(now + absl::Seconds(30))->key_id, "old");
  EXPECT_EQ(source.Get(now + absl::Seconds(90))->key_id, "new");
}

TEST_F(S3CredentialsTest, SaysWhereItLooked) {
  WriteFile("[other]\naws_access_key_id=a\naws_secret_access_key=hidden\n");
  auto source = Source();
  const absl::Status status = source.Get(absl::Now()).status();
  EXPECT_EQ(ErrorReason(status), "OBJECT_STORE_REFUSED");
  EXPECT_NE(std::string(status.message()).find("[default] in " + values_["AWS_SHARED_CREDENTIALS_FILE"]),
            std::string::npos);
  EXPECT_EQ(std::string(status.message()).find("hidden"), std::string::npos);
}

// The machine's role may have other rights.
TEST_F(S3CredentialsTest, TakesNoOtherRoleThanTheOneThatIsNamed) {
  values_["AWS_SHARED_CREDENTIALS_FILE"] = "/nowhere";
  values_["AWS_ROLE_ARN"] = "arn:aws:iam::1:role/city";
  values_["AWS_WEB_IDENTITY_TOKEN_FILE"] = "/nowhere/token";
  values_["AWS_CONTAINER_CREDENTIALS_FULL_URI"] = "http://127.0.0.1:1/";
  auto source = Source();
  EXPECT_NE(std::string(source.Get(absl::Now()).status().message()).find("nor the role AWS_ROLE_ARN"),
            std::string::npos);
  values_.erase("AWS_WEB_IDENTITY_TOKEN_FILE");
  EXPECT_NE(std::string(source.Get(absl::Now()).status().message()).find("nor the role of this container"),
            std::string::npos);
}

TEST_F(S3CredentialsTest, AsksForTheRoleOfTheMachineBeforeItExpires) {
  httplib::Server server;
  std::atomic<int> asked{0};
  server.Put("/latest/api/token", [](const httplib::Request&, httplib::Response& answer) { answer.body = "t1"; });
  server.Get("/latest/meta-data/iam/security-credentials/(.*)", [&](const httplib::Request& request,
                                                                    httplib::Response& answer) {
    if (request.get_header_value("X-aws-ec2-metadata-token") != "t1") {
      answer.status = 401;
    } else if (request.matches[1] == "") {
      answer.body = "role";
    } else {
      ++asked;
      answer.body = R"({"AccessKeyId":"r","SecretAccessKey":"s","Token":"t","Expiration":"2030-01-01T12:00:00Z"})";
    }
  });
  const int port = server.bind_to_any_port("127.0.0.1");
  std::thread serving([&] { server.listen_after_bind(); });
  imds_ = true;
  values_["AWS_EC2_METADATA_SERVICE_ENDPOINT"] = "http://127.0.0.1:" + std::to_string(port);
  values_["AWS_SHARED_CREDENTIALS_FILE"] = "/nowhere";
  auto source = Source();
  const absl::Time expiry = absl::FromCivil(absl::CivilSecond(2030, 1, 1, 12, 0, 0), absl::UTCTimeZone());
  const S3Credentials found = source.Get(expiry - absl::Hours(1)).value_or(S3Credentials{});
  EXPECT_EQ(found.key_id, "r");
  EXPECT_EQ(found.session_token, "t");
  EXPECT_TRUE(source.Get(expiry - absl::Minutes(6)).ok());
  EXPECT_EQ(asked.load(), 1);
  EXPECT_TRUE(source.Get(expiry - absl::Minutes(4)).ok());
  EXPECT_EQ(asked.load(), 2);
  server.stop();
  serving.join();
  EXPECT_TRUE(source.Get(expiry - absl::Minutes(3)).ok()) << "what holds still is used on";
  EXPECT_FALSE(source.Get(expiry + absl::Minutes(1)).ok());
}

}  // namespace
}  // namespace tilemend
