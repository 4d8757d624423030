// Who may do what by the calls that gRPC and the JSON mirror share.
#include "coordinator/api/guarded_calls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "tests/coordinator/api/coordinator_fixture.h"
#include "tests/support/list_log.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class GuardedCallsTest : public CoordinatorTest {
 protected:
  static Peer As(const std::string& token) {
    return {{"", {}, token}, "10.0.0.7:1", "0123456789abcdef0123456789abcdef"};
  }
  std::string Tokens() const {
    std::string text;
    for (const auto& [name, role] : {std::pair("ann", "submit"), std::pair("bob", "submit"), std::pair("eve", "watch"),
                                     std::pair("root", "admin"), std::pair("wrk", "worker")}) {
      text += std::string(name) + " " + role + " " + Sha256Hex(name) + "\n";
    }
    return folder_.Write("tokens", text);
  }

  TemporaryFolder folder_;
  PrometheusRegistry registry_;
  ListLog log_;
  Entrance entrance_{std::make_shared<Gate>(*Access::Closed(Tokens(), *Log::Null()), registry_, log_)};
  GuardedCalls guarded_{calls_, entrance_};
};

TEST_F(GuardedCallsTest, WhoHasNoNameOrTheWrongRoleSeesNothing) {
  EXPECT_EQ(ErrorReason(guarded_.ListJobs(As(""), {}).status()), "UNAUTHENTICATED");
  EXPECT_EQ(ErrorReason(guarded_.ListJobs(As("guess"), {}).status()), "UNAUTHENTICATED");
  EXPECT_EQ(ErrorReason(guarded_.ListJobs(As("wrk"), {}).status()), "ROLE_NEEDED");
  EXPECT_EQ(ErrorReason(guarded_.GetCells(As(""), "jobs/1").status()), "UNAUTHENTICATED");
  EXPECT_EQ(ErrorReason(guarded_.Identify(As("wrk")).status()), "ROLE_NEEDED");
  EXPECT_EQ(guarded_.Identify(As("eve"))->name, "eve");
}

TEST_F(GuardedCallsTest, OnlyTheOwnerAndAdministratorsSteerAJob) {
  const auto job = guarded_.CreateJob(As("ann"), NewRequest());
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->owner(), "ann");
  EXPECT_EQ(job->trace(), "0123456789abcdef0123456789abcdef");
  v1::PauseJobRequest pause;
  pause.set_name(job->name());
  EXPECT_EQ(ErrorReason(guarded_.PauseJob(As("eve"), pause).status()), "ROLE_NEEDED");
  EXPECT_EQ(ErrorReason(guarded_.PauseJob(As("bob"), pause).status()), "ROLE_NEEDED");
  EXPECT_TRUE(guarded_.PauseJob(As("ann"), pause)->paused());
  v1::ResumeJobRequest resume;
  resume.set_name(job->name());
  EXPECT_FALSE(guarded_.ResumeJob(As("root"), resume)->paused());
  v1::PrioritizeJobRequest priority;
  priority.set_name(job->name());
  priority.set_priority(7);
  EXPECT_EQ(guarded_.PrioritizeJob(As("ann"), priority)->priority(), 7);
  v1::CancelJobRequest cancel;
  cancel.set_name(job->name());
  EXPECT_EQ(ErrorReason(guarded_.CancelJob(As("bob"), cancel).status()), "ROLE_NEEDED");
  EXPECT_EQ(guarded_.CancelJob(As("ann"), cancel)->state(), v1::CANCELLED);
  v1::RetryJobRequest retry;
  retry.set_name(job->name());
  EXPECT_EQ(ErrorReason(guarded_.RetryJob(As("bob"), retry).status()), "ROLE_NEEDED");
  EXPECT_THAT(log_.lines(), Contains(HasSubstr("audit rpc=tilemend.v1.Jobs/CancelJob who=ann")));
}

TEST_F(GuardedCallsTest, TellsHowFarTheCellsAre) {
  const auto job = guarded_.CreateJob(As("ann"), NewRequest());
  ASSERT_TRUE(job.ok()) << job.status();
  const v1::Task task = AwaitTask();
  const auto cells = guarded_.GetCells(As("eve"), job->name());
  ASSERT_TRUE(cells.ok()) << cells.status();
  for (const CellId cell : {CellId{0, 0}, CellId{1, 0}}) EXPECT_EQ(cells->cells.At(cell), '.');
  EXPECT_EQ(cells->held.size(), 1);
  EXPECT_EQ(cells->state, JobState::kRunning);
  const auto workers = guarded_.ListWorkers(As("eve"), {});
  ASSERT_EQ(workers->workers_size(), 1);
  ASSERT_EQ(workers->workers(0).doing_size(), 1);
  EXPECT_EQ(workers->workers(0).doing(0).job(), job->name());
  v1::SyncRequest request = NewSync();
  Finish(task, request);
  Sync(request);
  EXPECT_GT(guarded_.GetCells(As("eve"), job->name())->version, cells->version);
  EXPECT_EQ(ErrorReason(guarded_.GetCells(As("eve"), "jobs/none").status()), "JOB_NOT_FOUND");
}

}  // namespace
}  // namespace tilemend
