#include "common/rpc/credential_keeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/metrics/prometheus_registry.h"
#include "common/util/files.h"
#include "tests/support/certificates.h"
#include "tests/support/list_log.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

std::string TextOf(const std::string& path) { return ReadOwnFile(path).value_or("none"); }

int64_t ChangeOf(const std::string& path) {
  struct stat info {};
  EXPECT_EQ(stat(path.c_str(), &info), 0);
  return info.st_mtime;
}

TEST(KeptTextTest, StandsAtOnePathWithAnotherTimeForEachText) {
  KeptText kept;
  EXPECT_EQ(kept.path(), "");
  ASSERT_TRUE(kept.Put("a longer text").ok());
  const std::string path = kept.path();
  const int64_t first = ChangeOf(path);
  EXPECT_EQ(TextOf(path), "a longer text");
  ASSERT_TRUE(kept.Put("short").ok());
  EXPECT_EQ(kept.path(), path);
  EXPECT_EQ(TextOf(path), "short");
  EXPECT_NE(ChangeOf(path), first);
}

class CredentialKeeperTest : public ::testing::Test {
 protected:
  ~CredentialKeeperTest() override { umask(mask_); }
  // Looks when it is told to.
  std::unique_ptr<CredentialKeeper> Start(const CredentialFiles& files) {
    auto keeper = CredentialKeeper::Start(files, log_, registry_);
    EXPECT_TRUE(keeper.ok()) << keeper.status();
    (*keeper)->StopLooking();
    log_.clear();
    return *std::move(keeper);
  }
  std::string Identity(const CredentialKeeper& keeper) { return TextOf(keeper.kept().tls.certificate); }

  const mode_t mask_ = umask(0077);
  TemporaryFolder folder_;
  TestAuthority authority_{folder_.path(), "ca"};
  ListLog log_;
  PrometheusRegistry registry_;
};

TEST_F(CredentialKeeperTest, HasNoPathWhereThereIsNoFile) {
  const auto keeper = Start({});
  EXPECT_TRUE(keeper->kept().tls.empty());
  EXPECT_EQ(keeper->kept().token + keeper->kept().metrics_token, "");
  const auto channel = Start({{"", "", authority_.path()}});
  EXPECT_EQ(channel->kept().tls.certificate + channel->kept().tls.key, "");
  EXPECT_EQ(TextOf(channel->kept().tls.authority), TextOf(authority_.path()));
}

TEST_F(CredentialKeeperTest, RefusesToBeginWithWhatIsOutOfOrder) {
  const TlsFiles a = authority_.Issue("a", {"a"}), b = authority_.Issue("b", {"b"});
  EXPECT_FALSE(CredentialKeeper::Start({{a.certificate, b.key, a.authority}}, log_, registry_).ok());
  EXPECT_FALSE(CredentialKeeper::Start({{}, folder_.Write("token", "two words")}, log_, registry_).ok());
}

TEST_F(CredentialKeeperTest, KeepsCertificateAndKeyInOneFileThatServes) {
  const TlsFiles files = authority_.Issue("a", {"a"});
  const auto keeper = Start({files});
  EXPECT_EQ(keeper->kept().tls.certificate, keeper->kept().tls.key);
  EXPECT_TRUE(CheckTlsFiles(keeper->kept().tls, files).ok());
  EXPECT_THAT(Identity(*keeper), AllOf(HasSubstr(TextOf(files.certificate)), HasSubstr(TextOf(files.key))));
}

TEST_F(CredentialKeeperTest, TakesNewCertificatesAndTellsTheirEnd) {
  const TlsFiles files = authority_.Issue("a", {"a"});
  const auto keeper = Start({files});
  const std::string before = Identity(*keeper);
  keeper->Look();
  EXPECT_THAT(log_.lines(), IsEmpty());
  authority_.Issue("a", {.name = "a", .from_s = -7200, .until_s = -3600});
  keeper->Look();
  EXPECT_NE(Identity(*keeper), before);
  EXPECT_THAT(log_.lines(), ElementsAre(AllOf(StartsWith("warning certificates read certificate=" + files.certificate),
                                              HasSubstr(" expires=20"))));
  EXPECT_THAT(registry_.Text(), HasSubstr("tilemend_certificate_expiry_timestamp_seconds "));
}

TEST_F(CredentialKeeperTest, KeepsTheOldOnesWhereTheNewAreNone) {
  const TlsFiles files = authority_.Issue("a", {"a"});
  const auto keeper = Start({files});
  const std::string before = Identity(*keeper), authority = TextOf(keeper->kept().tls.authority);
  const std::string certificate = TextOf(files.certificate);
  const TlsFiles other = authority_.Issue("b", {"b"});
  const std::vector<std::pair<std::string, std::string>> faults = {
      {files.certificate, "garbage with a secret"},
      {files.certificate, certificate.substr(0, certificate.size() / 2)},
      {files.certificate, ""},
      {files.certificate, TextOf(other.certificate)},  // the key does not fit yet
      {files.authority, "garbage"}};
  for (const auto& [path, text] : faults) {
    const std::string right = TextOf(path);
    log_.clear();
    ASSERT_TRUE(WriteFileAtomically(path, text).ok());
    keeper->Look();
    keeper->Look();
    EXPECT_THAT(log_.lines(),
                ElementsAre(AllOf(StartsWith("warning certificates not read error="),
                                  HasSubstr(path == files.certificate ? folder_ / "a." : path),
                                  HasSubstr("in_use=\"what was read before\""), Not(HasSubstr("secret")))));
    EXPECT_EQ(Identity(*keeper), before);
    EXPECT_EQ(TextOf(keeper->kept().tls.authority), authority);
    ASSERT_TRUE(WriteFileAtomically(path, right).ok());
    keeper->Look();
  }
  std::filesystem::remove(files.key);
  keeper->Look();
  EXPECT_EQ(Identity(*keeper), before);
  EXPECT_THAT(log_.lines().back(), HasSubstr("a.key: cannot open"));
}

TEST_F(CredentialKeeperTest, TellsOfFilesThatAllMayRead) {
  const TlsFiles files = authority_.Issue("a", {"a"});
  const std::string token = folder_.Write("token", "t"), metrics = folder_.Write("metrics", "m");
  for (const std::string& file : {files.key, token, metrics}) {
    for (const std::string& other : {files.key, token, metrics}) {
      std::filesystem::permissions(other, static_cast<std::filesystem::perms>(other == file ? 0604 : 0640));
    }
    ASSERT_TRUE(CredentialKeeper::Start({files, token, metrics}, log_, registry_).ok());
    EXPECT_THAT(log_.lines(),
                ElementsAre(StartsWith("info certificates read"), "warning all may read file=" + file + "\n"));
    log_.clear();
  }
}

TEST_F(CredentialKeeperTest, KeepsTokensThatACallMayCarry) {
  const std::string token = folder_.Write("token", "first\n"), metrics = folder_.Write("metrics", "m1");
  const auto keeper = Start({{}, token, metrics});
  EXPECT_EQ(TextOf(keeper->kept().token), "first");
  folder_.Write("token", "");
  std::filesystem::remove(metrics);
  keeper->Look();
  EXPECT_EQ(TextOf(keeper->kept().token), "first");
  EXPECT_EQ(TextOf(keeper->kept().metrics_token), "m1");
  EXPECT_THAT(log_.lines(), ElementsAre(StartsWith("warning token not read error="),
                                        StartsWith("warning token of the metrics not read error=")));
  log_.clear();
  folder_.Write("token", "second");
  folder_.Write("metrics", "m2");
  keeper->Look();
  EXPECT_EQ(TextOf(keeper->kept().token), "second");
  EXPECT_EQ(TextOf(keeper->kept().metrics_token), "m2");
  EXPECT_THAT(log_.lines(),
              ElementsAre("info token read file=" + token + "\n", "info token read file=" + metrics + "\n"));
}

}  // namespace
}  // namespace tilemend
