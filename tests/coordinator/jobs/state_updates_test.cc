// What follows from events.
#include "coordinator/jobs/state_updates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/coordinator/api/coordinator_fixture.h"

namespace tilemend {
namespace {

using StateUpdatesTest = CoordinatorTest;

TEST_F(StateUpdatesTest, AnErrorThatAnotherWorkerDoesNotHaveIsToldInFewPrintableWords) {
  const auto job = calls_.jobs.CreateJob(NewRequest());
  const v1::Task task = AwaitTask("broken"), second = AwaitTask("other");
  v1::SyncRequest report = NewSync("broken", 0);
  auto* finished = report.add_finished();
  *finished->mutable_ref() = task.ref();
  finished->set_stage(task.stage());
  finished->mutable_error()->set_code(static_cast<int>(absl::StatusCode::kInvalidArgument));
  finished->mutable_error()->set_message("\x1b[2J" + std::string(1 << 20, 'x'));
  Sync(report);
  v1::SyncRequest done = NewSync("other");
  Finish(second, done);
  const v1::SyncResponse next = Sync(done);
  ASSERT_EQ(next.start_size(), 1);
  EXPECT_EQ(next.start(0).ref().task(), task.ref().task());
  done = NewSync("other", 0);
  Finish(next.start(0), done);
  Sync(done);
  const v1::Job told = cluster_.Get(job->name());
  ASSERT_EQ(told.warnings_size(), 1);
  EXPECT_EQ(told.warnings(0).find('\x1b'), std::string::npos);
  EXPECT_LT(told.warnings(0).size(), 4000U);
  EXPECT_NE(told.warnings(0).find("worker broken could not do cell"), std::string::npos);
}

}  // namespace
}  // namespace tilemend
