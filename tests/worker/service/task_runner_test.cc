#include "worker/service/task_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>

#include "common/rpc/status_proto.h"
#include "common/util/error_info.h"
#include "tests/worker/service/worker_fixture.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST_F(WorkerTest, ReportsAnErrorAsItIs) {
  const absl::Status error = WithErrorInfo(absl::NotFoundError("a.ply: no such file"), {"TILE", {}});
  const auto report = Run(
      [&](Stage, const std::string&, const CancelToken&) { return absl::StatusOr<std::string>(error); }, TaskOf(1, ""));
  EXPECT_EQ(StatusFromProto(report.error()), error);
  EXPECT_EQ(report.stage(), static_cast<v1::Stage>(Stage::kFill));
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_tasks_failed_total{stage=\"fill\"} 1\n"));
}

TEST_F(WorkerTest, ReportsWhatAStageThrows) {
  using Output = absl::StatusOr<std::string>;
  const auto throws = [](Stage, const std::string&, const CancelToken&) -> Output { throw std::runtime_error("oops"); };
  EXPECT_EQ(StatusFromProto(Run(throws, TaskOf(1, "")).error()), absl::InternalError("stage fill threw: oops"));
  const auto starves = [](Stage, const std::string&, const CancelToken&) -> Output { throw std::bad_alloc(); };
  EXPECT_EQ(StatusFromProto(Run(starves, TaskOf(2, "")).error()),
            absl::ResourceExhaustedError("the worker is out of memory"));
}

TEST_F(WorkerTest, TellsWhatItHasBegun) {
  const auto worker = WorkerOnTheFirstOfTwo();
  v1::SyncResponse keep;
  *keep.add_keep() = Ref(1);
  *keep.add_keep() = Ref(2);
  const auto tells = [](const v1::SyncRequest& request) { return request.begun_size() > 0; };
  coordinator_.Answer(keep);  // the call that was under way when the task began
  const v1::SyncRequest request = coordinator_.Answer(keep, tells);
  EXPECT_EQ(request.held_size(), 2);
  EXPECT_EQ(request.begun_size(), 1) << "there is one thread";
  worker->Abandon();
}

}  // namespace
}  // namespace tilemend
