#include "common/rpc/credentials.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <openssl/pem.h>

#include <cstdio>
#include <memory>
#include <string>

#include "common/util/files.h"
#include "tests/support/certificates.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(CheckServerSecurityTest, KeepsPlainTextOnThisMachine) {
  for (const char* here : {"127.0.0.1:7070", "127.8.8.8:1", "localhost:0", "[::1]:7070"}) {
    EXPECT_TRUE(CheckServerSecurity({}, here).ok()) << here;
  }
  for (const char* beyond : {"0.0.0.0:7070", "10.1.2.3:7070", "[::]:7070", "example.org:7070", "localhost.example:1",
                             "127.0.0.1.example.org:1", "127.example.org:1", "127.:1"}) {
    const absl::Status status = CheckServerSecurity({}, beyond);
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << beyond;
    EXPECT_THAT(std::string(status.message()), HasSubstr("--insecure")) << beyond;
    EXPECT_FALSE(CheckChannelSecurity({}, beyond).ok()) << beyond;
    EXPECT_TRUE(CheckServerSecurity({{}, "", true}, beyond).ok()) << beyond;
  }
}

TEST(CheckChannelSecurityTest, EachEndIsToldOfTheFlagsThatItNeeds) {
  EXPECT_THAT(std::string(CheckServerSecurity({}, "host:1").message()),
              HasSubstr("give --tls-cert and --tls-key, or --insecure"));
  EXPECT_THAT(std::string(CheckServerSecurity({{}, "/a/token"}, "host:1").message()), Not(HasSubstr("token")))
      << "a listener sends none";
  EXPECT_THAT(std::string(CheckChannelSecurity({}, "host:1").message()),
              HasSubstr("give --tls-ca (and --tls-cert and"));
}

TEST(CheckChannelSecurityTest, ATokenInPlainTextSaysWhatIsMissing) {
  Security security;
  security.token_file = "/no/such/token";
  const absl::Status status = CheckChannelSecurity(security, "host:1");
  EXPECT_THAT(std::string(status.message()), HasSubstr("--tls-ca is missing: without TLS the token would leave"));
}

TEST(CheckServerSecurityTest, RefusesFilesThatDoNotBelongTogether) {
  const TemporaryFolder folder;
  const TestAuthority authority(folder.path(), "ca");
  const TlsFiles a = authority.Issue("a", {"a"}), b = authority.Issue("b", {"b"});
  const std::string address = "0.0.0.0:1";
  EXPECT_TRUE(CheckServerSecurity({a}, address).ok());
  EXPECT_FALSE(CheckServerSecurity({{a.certificate, b.key, a.authority}}, address).ok());
  EXPECT_FALSE(CheckServerSecurity({{a.certificate, "", ""}}, address).ok());
  EXPECT_FALSE(CheckServerSecurity({{"", "", a.authority}}, address).ok());
  EXPECT_TRUE(CheckChannelSecurity({{"", "", a.authority}}, address).ok());
  EXPECT_TRUE(absl::IsNotFound(CheckServerSecurity({{"/no.pem", "/no.key", ""}}, address)));
}

TEST(CheckServerSecurityTest, QuotesNothingOfAFile) {
  const TemporaryFolder folder;
  const std::string path = folder / "private.txt";
  ASSERT_TRUE(WriteFileAtomically(path, "my secret line\n").ok());
  for (const Security& security : {Security{{path, path, ""}}, Security{{"", "", path}}}) {
    const absl::Status status = CheckChannelSecurity(security, "host:1");
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), Not(HasSubstr("secret")));
  }
}

TEST(CheckServerSecurityTest, AsksNobodyForTheKeyOfAKey) {
  const TemporaryFolder folder;
  const TlsFiles files = TestAuthority(folder.path(), "ca").Issue("a", {"a"});
  const std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key(EVP_EC_gen("P-256"), EVP_PKEY_free);
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(std::fopen(files.key.c_str(), "w"), std::fclose);
  std::string password = "secret";
  ASSERT_EQ(PEM_write_PrivateKey(file.get(), key.get(), EVP_aes_128_cbc(),
                                 reinterpret_cast<unsigned char*>(password.data()), 6, nullptr, nullptr),
            1);
  std::fflush(file.get());
  EXPECT_TRUE(absl::IsInvalidArgument(CheckServerSecurity({files}, "0.0.0.0:1")));
}

TEST(ReadTokenTest, TakesOneWordThatACallMayCarry) {
  const TemporaryFolder folder;
  EXPECT_EQ(*ReadToken(folder.Write("token", " secret-123\n")), "secret-123");
  for (const std::string& text : {std::string(), std::string("\n"), std::string("two words"), std::string("two\nlines"),
                                  std::string("\x7f\x45\x4c\x46"), std::string("n\0l", 3), std::string("Z\xc3\xbcrich"),
                                  std::string(4097, 'a')}) {
    const std::string path = folder.Write("token", text);
    EXPECT_TRUE(absl::IsInvalidArgument(ReadToken(path).status())) << text;
    EXPECT_TRUE(absl::IsInvalidArgument(CheckChannelSecurity({{}, path, true}, "host:1"))) << text;
  }
  EXPECT_TRUE(absl::IsNotFound(ReadToken(folder / "none").status()));
}

TEST(SecurityFlagsTest, AreReadAsTheyAreTold) {
  const auto flags =
      Flags::Parse(ChannelSecurityFlags(), {"--tls-ca", "a", "--tls-cert=c", "--tls-key", "k", "--token-file", "t"});
  ASSERT_TRUE(flags.ok());
  const Security security = SecurityFromFlags(*flags);
  EXPECT_EQ(security.tls.authority, "a");
  EXPECT_EQ(security.tls.certificate, "c");
  EXPECT_EQ(security.tls.key, "k");
  EXPECT_EQ(security.token_file, "t");
  EXPECT_FALSE(security.plaintext);
}

}  // namespace
}  // namespace tilemend
