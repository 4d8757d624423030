#include "coordinator/jobs/worker_trust.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using testing::HasSubstr;

class WorkerTrustTest : public testing::Test {
 protected:
  WorkerTrustTest() { trust_.AddJob("j", {{{"/scene/scene.json", "print"}}, "/out/attempts"}); }
  static v1::FoldersSeen Seen(const std::string& fingerprint) {
    v1::FoldersSeen seen;
    seen.set_job("j");
    seen.add_files()->set_fingerprint(fingerprint);
    return seen;
  }
  size_t Looks(const std::set<std::string>& busy = {}) const { return trust_.ToLookAt("w", busy, now_).size(); }

  WorkerTrust trust_;
  absl::Time now_ = absl::FromUnixSeconds(1000);
};

TEST_F(WorkerTrustTest, AWorkerMayWorkWhenItHasSeenTheFolders) {
  EXPECT_TRUE(trust_.MayWorkOn("w", "another"));
  EXPECT_FALSE(trust_.MayWorkOn("w", "j"));
  ASSERT_EQ(Looks(), 1U);
  const v1::JobFolders look = trust_.ToLookAt("w", {}, now_)[0];
  EXPECT_EQ(look.job(), "j");
  EXPECT_EQ(look.files(0), "/scene/scene.json");
  EXPECT_EQ(look.attempts(), "/out/attempts");
  EXPECT_EQ(Looks({"j"}), 0U) << "it is at it";
  EXPECT_FALSE(trust_.TakeSeen("w", Seen("print"), now_).has_value());
  EXPECT_TRUE(trust_.MayWorkOn("w", "j"));
  EXPECT_FALSE(trust_.MayWorkOn("other", "j"));
  EXPECT_EQ(Looks(), 0U);
  EXPECT_EQ(trust_.Count().blind, 0U);
}

TEST_F(WorkerTrustTest, OneThatSeesOthersIsToldOfAndAskedAgainLater) {
  EXPECT_THAT(trust_.TakeSeen("w", Seen("other"), now_).value_or(""), HasSubstr("/scene/scene.json: another file"));
  EXPECT_FALSE(trust_.MayWorkOn("w", "j"));
  EXPECT_EQ(trust_.Count().blind, 1U);
  EXPECT_EQ(Looks(), 0U);
  now_ += absl::Minutes(1);
  EXPECT_EQ(Looks(), 1U);
  EXPECT_FALSE(trust_.TakeSeen("w", Seen("print"), now_).has_value());
  EXPECT_TRUE(trust_.MayWorkOn("w", "j"));
}

TEST_F(WorkerTrustTest, ErrorsAreToldInAFewWords) {
  v1::FoldersSeen seen = Seen("print");
  seen.set_write_error(std::string(1 << 20, 'x'));
  EXPECT_LT(trust_.TakeSeen("w", seen, now_).value_or("").size(), 1000U);
  seen = Seen("");
  seen.mutable_files(0)->set_error("cannot open\n");
  EXPECT_THAT(trust_.TakeSeen("w", seen, now_).value_or(""), HasSubstr("cannot open"));
  seen.clear_files();
  EXPECT_TRUE(trust_.TakeSeen("w", seen, now_).has_value());
}

TEST_F(WorkerTrustTest, IsForgottenWithTheWorkerTheJobOrADoubt) {
  trust_.TakeSeen("w", Seen("print"), now_);
  trust_.Doubt("w", "j");
  EXPECT_FALSE(trust_.MayWorkOn("w", "j"));
  trust_.TakeSeen("w", Seen("print"), now_);
  trust_.RemoveWorker("w");
  EXPECT_FALSE(trust_.MayWorkOn("w", "j"));
  trust_.RemoveJob("j");
  EXPECT_TRUE(trust_.MayWorkOn("w", "j"));
  EXPECT_EQ(Looks(), 0U);
}

TEST_F(WorkerTrustTest, OneThatLooksForLongSeemsStuckUntilItHasSeen) {
  v1::FoldersSeen looking;
  looking.set_job("j");
  looking.set_looking(true);
  EXPECT_FALSE(trust_.SeemsStuck("w", "j", now_));
  for (int second = 0; second < 6; ++second) trust_.TakeSeen("w", looking, now_ + absl::Seconds(second));
  EXPECT_FALSE(trust_.SeemsStuck("w", "j", now_ + absl::Seconds(5)));
  EXPECT_TRUE(trust_.SeemsStuck("w", "j", now_ + absl::Seconds(6)));
  EXPECT_FALSE(trust_.SeemsStuck("other", "j", now_ + absl::Seconds(6)));
  EXPECT_FALSE(trust_.IsBarred("w", "j")) << "it may come back";
  trust_.TakeSeen("w", Seen("print"), now_ + absl::Seconds(7));
  EXPECT_FALSE(trust_.SeemsStuck("w", "j", now_ + absl::Seconds(20)));
  trust_.TakeSeen("w", looking, now_);
  trust_.RemoveWorker("w");
  EXPECT_FALSE(trust_.SeemsStuck("w", "j", now_ + absl::Seconds(20)));
}

TEST_F(WorkerTrustTest, OneThatIsSetAsideGetsNothing) {
  trust_.TakeSeen("w", Seen("print"), now_);
  trust_.SetAside("w", "it lied");
  EXPECT_FALSE(trust_.MayWorkOn("w", "j"));
  EXPECT_FALSE(trust_.MayWorkOn("w", "another"));
  EXPECT_EQ(trust_.WhySetAside("w"), "it lied");
  EXPECT_EQ(trust_.Count().set_aside, 1U);
  EXPECT_FALSE(trust_.Clear("w"));
  EXPECT_TRUE(trust_.IsBarred("w", "job"));
  trust_.RemoveWorker("w");
  EXPECT_FALSE(trust_.MayWorkOn("w", "another")) << "it only went silent";
}

TEST_F(WorkerTrustTest, OneThatIsSuspectedGetsNothingUntilItIsCleared) {
  trust_.Suspect("w", "it may have lied");
  EXPECT_FALSE(trust_.MayWorkOn("w", "another"));
  EXPECT_EQ(trust_.WhySetAside("w"), "it may have lied");
  EXPECT_TRUE(trust_.Clear("w"));
  EXPECT_TRUE(trust_.MayWorkOn("w", "another"));
  EXPECT_FALSE(trust_.Clear("w"));
}

}  // namespace
}  // namespace tilemend
