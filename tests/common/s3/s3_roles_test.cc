#include "common/s3/s3_roles.h"

#include <gtest/gtest.h>
#include <httplib.h>

#include <map>
#include <string>
#include <thread>

#include "absl/strings/str_cat.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

// Services that give credentials, in this process.
class S3RolesTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
      asked_ = request;
      response.status = status_;
      response.body = answer_;
    };
    server_.Get(".*", answer);
    server_.Post(".*", answer);
    const int port = server_.bind_to_any_port("127.0.0.1");
    serving_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::yield();  // or it would not hear that it is to stop
    address_ = absl::StrCat("http://127.0.0.1:", port);
  }
  void TearDown() override {
    server_.stop();
    serving_.join();
  }
  Environment Variables() {
    return [this](const char* name) {
      const auto found = values_.find(name);
      return found == values_.end() ? nullptr : found->second.c_str();
    };
  }

  httplib::Server server_;
  std::thread serving_;
  std::string address_, answer_;
  int status_ = 200;
  httplib::Request asked_;
  TemporaryFolder folder_;
  std::map<std::string, std::string> values_;
};

constexpr char kOfContainer[] =
    R"({"AccessKeyId":"c","SecretAccessKey":"s","Token":"t","Expiration":"2030-01-01T12:00:00Z","RoleArn":"x"})";
constexpr char kOfWebIdentity[] =
    R"(<AssumeRoleWithWebIdentityResponse xmlns="https://sts.amazonaws.com/doc/2011-06-15/">
 <AssumeRoleWithWebIdentityResult><Credentials>
  <SessionToken>t</SessionToken><SecretAccessKey>s</SecretAccessKey>
  <Expiration>2030-01-01T12:00:00Z</Expiration><AccessKeyId>w</AccessKeyId>
 </Credentials></AssumeRoleWithWebIdentityResult></AssumeRoleWithWebIdentityResponse>)";

TEST_F(S3RolesTest, ShowsTheTokenOfAPodToTheTokenService) {
  values_ = {{"AWS_ROLE_ARN", "arn:aws:iam::1:role/city"},
             {"AWS_WEB_IDENTITY_TOKEN_FILE", folder_.Write("token", "a.b+c\n")},
             {"AWS_ENDPOINT_URL_STS", address_}};
  answer_ = kOfWebIdentity;
  const auto role = RoleOfWebIdentity(Variables());
  ASSERT_TRUE(role.has_value());
  EXPECT_EQ(role->credentials.key_id, "w");
  EXPECT_EQ(role->credentials.secret, "s");
  EXPECT_EQ(role->credentials.session_token, "t");
  EXPECT_EQ(role->expires - role->renew, absl::Minutes(5));
  EXPECT_EQ(asked_.method, "POST");
  EXPECT_EQ(asked_.get_param_value("Action"), "AssumeRoleWithWebIdentity");
  EXPECT_EQ(asked_.get_param_value("RoleArn"), "arn:aws:iam::1:role/city");
  EXPECT_EQ(asked_.get_param_value("WebIdentityToken"), "a.b+c");
  status_ = 403;
  EXPECT_FALSE(RoleOfWebIdentity(Variables()).has_value());
}

TEST_F(S3RolesTest, AsksNobodyWithoutAToken) {
  values_ = {{"AWS_ROLE_ARN", "arn"}, {"AWS_WEB_IDENTITY_TOKEN_FILE", "/nowhere"}, {"AWS_ENDPOINT_URL_STS", address_}};
  answer_ = kOfWebIdentity;
  EXPECT_FALSE(RoleOfWebIdentity(Variables()).has_value());
  EXPECT_EQ(asked_.method, "");
}

TEST_F(S3RolesTest, ShowsTheTokenOfAContainer) {
  values_ = {{"AWS_CONTAINER_CREDENTIALS_FULL_URI", address_ + "/v1/credentials"},
             {"AWS_CONTAINER_AUTHORIZATION_TOKEN_FILE", folder_.Write("token", "secret")}};
  answer_ = kOfContainer;
  const auto role = RoleOfContainer(Variables());
  ASSERT_TRUE(role.has_value());
  EXPECT_EQ(role->credentials.key_id, "c");
  EXPECT_EQ(asked_.path, "/v1/credentials");
  EXPECT_EQ(asked_.get_header_value("Authorization"), "secret");
}

// The name leads to the same server as 127.0.0.1, and could lead anywhere.
TEST_F(S3RolesTest, ShowsNoTokenToOtherMachinesWithoutTls) {
  answer_ = kOfContainer;
  const std::string port = address_.substr(address_.rfind(':'));
  for (const char* host : {"127.0.0.2", "127.0.0.1.example.org", "127.0.0.1@127.0.0.2", "localhost:1@127.0.0.2"}) {
    values_["AWS_CONTAINER_CREDENTIALS_FULL_URI"] = absl::StrCat("http://", host, port, "/");
    EXPECT_FALSE(RoleOfContainer(Variables()).has_value()) << host;
  }
  EXPECT_EQ(asked_.method, "");
}

TEST_F(S3RolesTest, TakesNoAnswerWithoutAKeyOrATime) {
  EXPECT_TRUE(CredentialsOfRole(kOfContainer).has_value());
  EXPECT_FALSE(CredentialsOfRole(R"({"AccessKeyId":"c","SecretAccessKey":"s"})").has_value());
  EXPECT_FALSE(CredentialsOfRole(R"({"AccessKeyId":7,"SecretAccessKey":"s","Expiration":"2030-01-01T12:00:00Z"})"));
  EXPECT_FALSE(CredentialsOfRole("[]").has_value());
  EXPECT_FALSE(CredentialsOfRole("").has_value());
}

}  // namespace
}  // namespace tilemend
