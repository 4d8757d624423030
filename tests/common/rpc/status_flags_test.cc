#include "common/rpc/status_flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/rpc/credentials.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

class StatusFlagsTest : public ::testing::Test {
 protected:
  static Flags Parse(const std::vector<std::string>& words) {
    std::vector<FlagSpec> specs = StatusFlags();
    for (const FlagSpec& spec : ServerSecurityFlags()) specs.push_back(spec);
    return *Flags::Parse(specs, words);
  }
  static std::string Fault(const std::vector<std::string>& words) {
    return std::string(CheckStatusFlags(Parse(words)).message());
  }
  std::string Token() { return "--metrics-token=" + folder_.Write("token", "secret"); }
  TemporaryFolder folder_;
};

TEST_F(StatusFlagsTest, NothingIsServedAndNothingIsWrongWithoutAnAddress) {
  EXPECT_EQ(Fault({}), "");
  EXPECT_EQ(Fault({"--metrics-tls"}), "");
}

TEST_F(StatusFlagsTest, TheAddressIsHostAndPort) {
  EXPECT_THAT(Fault({"--metrics=9100"}), HasSubstr("expected HOST:PORT"));
  EXPECT_EQ(Fault({"--metrics=0.0.0.0:9100"}), "");
}

TEST_F(StatusFlagsTest, TlsTakesTheCertificateOfTheProgram) {
  EXPECT_THAT(Fault({"--metrics=0.0.0.0:9100", "--metrics-tls"}), HasSubstr("needs --tls-cert and --tls-key"));
  const std::vector<std::string> words = {"--metrics=0.0.0.0:9100", "--tls-cert=c", "--tls-key=k"};
  const CredentialFiles files = {{"kept.pem", "kept.pem", ""}, "", "kept token"};
  EXPECT_EQ(StatusSecurityFromFlags(Parse(words), files).certificate, "");
  EXPECT_EQ(StatusSecurityFromFlags(Parse(words), files).token_file, "kept token");
  std::vector<std::string> more = words;
  more.emplace_back("--metrics-tls");
  EXPECT_EQ(Fault(more), "");
  EXPECT_EQ(StatusSecurityFromFlags(Parse(more), files).certificate, "kept.pem");
  EXPECT_EQ(StatusSecurityFromFlags(Parse(more), files).key, "kept.pem");
}

TEST_F(StatusFlagsTest, ATokenDoesNotLeaveThisMachineInPlainText) {
  EXPECT_THAT(Fault({"--metrics=0.0.0.0:9100", Token()}), HasSubstr("plain text"));
  EXPECT_EQ(Fault({"--metrics=127.0.0.1:9100", Token()}), "");
  EXPECT_EQ(Fault({"--metrics=0.0.0.0:9100", Token(), "--insecure"}), "");
  EXPECT_EQ(Fault({"--metrics=0.0.0.0:9100", Token(), "--metrics-tls", "--tls-cert=c", "--tls-key=k"}), "");
  EXPECT_THAT(Fault({"--metrics=127.0.0.1:9100", "--metrics-token=/not/there"}), HasSubstr("/not/there"));
  EXPECT_THAT(Fault({"--metrics=127.0.0.1:9100", "--metrics-token=" + folder_.Write("empty", "\n")}),
              HasSubstr("expected a token"));
}

}  // namespace
}  // namespace tilemend
