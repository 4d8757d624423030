#include "coordinator/api/access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "tests/support/list_log.h"
#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const absl::Time kNow = absl::FromUnixSeconds(1'800'000'000);
constexpr char kGet[] = "tilemend.v1.Jobs/GetJob";

TEST(CallerTest, GreaterRolesMayWhatLesserOnesMay) {
  const Caller admin{"a", {Role::kAdmin}}, submit{"s", {Role::kSubmit}}, watch{"w", {Role::kWatch}};
  EXPECT_TRUE(admin.May(Role::kSubmit) && admin.May(Role::kWatch) && submit.May(Role::kWatch));
  EXPECT_FALSE(watch.May(Role::kSubmit) || submit.May(Role::kAdmin) || admin.May(Role::kWorker));
  EXPECT_FALSE((Caller{"x", {Role::kWorker}}).May(Role::kWatch));
  const Caller scale{"k", {Role::kScale}};
  EXPECT_TRUE(watch.May(Role::kScale) && admin.May(Role::kScale) && scale.May(Role::kScale));
  EXPECT_FALSE(scale.May(Role::kWatch) || (Caller{"x", {Role::kWorker}}).May(Role::kScale));
  EXPECT_TRUE(Caller().May(Role::kAnybody));
}

TEST(NeedOfTest, IsTheMostForWhatNobodyKnows) { EXPECT_EQ(NeedOf("tilemend.v1.Jobs/DropAll"), Role::kAdmin); }

TEST(ParseTokensTest, ReadsNamesRolesAndTheirEnd) {
  const std::string digest = Sha256Hex("secret");
  const auto tokens =
      ParseTokens(absl::StrCat("# people\n\nann  submit,worker\t", digest, " 2030-01-01T00:00:00Z # till then\n"), "t");
  ASSERT_TRUE(tokens.ok()) << tokens.status();
  const KnownToken& token = tokens->at(digest);
  EXPECT_EQ(token.name, "ann");
  EXPECT_EQ(token.roles, (std::set<Role>{Role::kSubmit, Role::kWorker}));
  EXPECT_EQ(token.expires, absl::FromUnixSeconds(1'893'456'000));
}

TEST(ParseTokensTest, NamesTheLineAndNothingOfIt) {
  const std::string digest = Sha256Hex("secret");
  for (const std::string& line : {std::string("ann submit secret"), "ann king " + digest, "ann " + digest,
                                  "ann submit " + digest + " tomorrow"}) {
    const absl::Status status = ParseTokens("\n" + line, "tokens").status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << line;
    EXPECT_THAT(std::string(status.message()), HasSubstr("tokens:2: expected NAME ROLE")) << line;
    EXPECT_THAT(std::string(status.message()), Not(HasSubstr("secret"))) << line;
    EXPECT_THAT(std::string(status.message()), Not(HasSubstr("ann"))) << line;
  }
}

TEST(AccessTest, IsOpenToAllWhereNobodyHasAName) {
  Access access = Access::Open();
  for (const RpcNeed& need : RpcNeeds()) EXPECT_TRUE(access.Admit(need.rpc, {}, kNow).ok()) << need.rpc;
}

TEST(AccessTest, TakesNameAndRolesFromTheCertificate) {
  auto access = Access::Closed("", *Log::Null());
  ASSERT_TRUE(access.ok());
  const auto caller = access->Admit(kGet, {"ann", {"localhost", "tilemend:role:watch"}, ""}, kNow);
  ASSERT_TRUE(caller.ok()) << caller.status();
  EXPECT_EQ(caller->name, "ann");
  EXPECT_EQ(ErrorReason(access->Admit(kGet, {"bob", {"localhost"}, ""}, kNow).status()), "ROLE_NEEDED");
  EXPECT_EQ(ErrorReason(access->Admit(kGet, {}, kNow).status()), "UNAUTHENTICATED");
}

TEST(AccessTest, ATokenCountsAndNotTheCertificateBesideIt) {
  TempFolder folder;
  ASSERT_TRUE(WriteFileAtomically(folder / "t", absl::StrCat("ann watch ", Sha256Hex("x"))).ok());
  auto access = Access::Closed(folder / "t", *Log::Null());
  ASSERT_TRUE(access.ok());
  const std::vector<std::string> admin = {"tilemend:role:admin"};
  EXPECT_EQ(access->Admit(kGet, {"eve", admin, "x"}, kNow)->name, "ann");
  EXPECT_FALSE(access->Admit("tilemend.v1.Jobs/CreateJob", {"eve", admin, "x"}, kNow).ok());
  EXPECT_TRUE(absl::IsUnauthenticated(access->Admit(kGet, {"eve", admin, "y"}, kNow).status()));
}

TEST(AccessTest, SeesThatItsFileChangedAndThatTokensExpire) {
  TempFolder folder;
  const std::string line = absl::StrCat("ann watch ", Sha256Hex("x"));
  ASSERT_TRUE(WriteFileAtomically(folder / "t", line + " 2030-01-01T00:00:00Z\n").ok());
  ListLog log;
  auto access = Access::Closed(folder / "t", log);
  ASSERT_TRUE(access.ok());
  EXPECT_TRUE(access->Admit(kGet, {"", {}, "x"}, kNow).ok());
  EXPECT_THAT(log.lines(), IsEmpty());
  EXPECT_FALSE(Access::Closed(folder / "t", *Log::Null())
                   ->Admit(kGet, {"", {}, "x"}, absl::FromUnixSeconds(1'893'456'000))
                   .ok());
  ASSERT_TRUE(WriteFileAtomically(folder / "t", "half a li").ok());
  for (const int64_t now : {1'893'455'990, 1'893'455'993}) {
    EXPECT_TRUE(access->Admit(kGet, {"", {}, "x"}, absl::FromUnixSeconds(now)).ok());  // as it was
  }
  EXPECT_THAT(log.lines(),
              ElementsAre(AllOf(StartsWith("warning tokens not read error="), HasSubstr("/t:1: expected NAME"),
                                HasSubstr("in_use=\"what was read before\""))));
  ASSERT_TRUE(WriteFileAtomically(folder / "t", "").ok());
  EXPECT_FALSE(access->Admit(kGet, {"", {}, "x"}, absl::FromUnixSeconds(1'893'455'999)).ok());
  EXPECT_EQ(log.lines().back(), absl::StrCat("info tokens read file=", folder / "t", " tokens=0\n"));
}

TEST(AccessTest, NeedsAFileThatItCanRead) {
  EXPECT_TRUE(absl::IsNotFound(Access::Closed("/nowhere/tokens", *Log::Null()).status()));
}

}  // namespace
}  // namespace tilemend
