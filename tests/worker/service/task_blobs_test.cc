#include "worker/service/task_blobs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/rpc/limits.h"
#include "common/rpc/status_proto.h"
#include "common/store/digest.h"
#include "tests/worker/service/worker_fixture.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST_F(WorkerTest, AppendsThePartsThatAnInputNames) {
  v1::GroundInput head, part;
  head.add_position(1);
  head.add_parts("raster");
  part.add_rasters()->set_square(2);
  coordinator_.PutBlob("raster", part.SerializeAsString());
  v1::Task task = TaskOf(1, head.SerializeAsString());
  task.set_stage(static_cast<v1::Stage>(Stage::kGround));
  const auto give_back = [](Stage, const std::string& input, const CancelToken&) { return input; };
  v1::GroundInput whole;
  ASSERT_TRUE(whole.ParseFromString(Run(give_back, task).output().content()));
  EXPECT_EQ(whole.position_size(), 1);
  ASSERT_EQ(whole.rasters_size(), 1);
  EXPECT_EQ(whole.rasters(0).square(), 2);
}

TEST_F(WorkerTest, ReadsALargeInputAsABlob) {
  const std::string input(100'000, 'x');
  v1::Task task = TaskOf(1, "");
  task.mutable_input()->set_size(static_cast<int64_t>(input.size()));
  task.mutable_input()->set_digest(Sha256Hex(input));
  EXPECT_EQ(StatusFromProto(Run(Echo, task).error()).code(), absl::StatusCode::kUnavailable) << "it is lost";
  coordinator_.PutBlob(Sha256Hex(input), input);
  const auto size = [](Stage, const std::string& bytes, const CancelToken&) -> absl::StatusOr<std::string> {
    return std::to_string(bytes.size());
  };
  EXPECT_EQ(Run(size, task).output().content(), "100000");
  EXPECT_THAT(metrics_.Text(), HasSubstr("tilemend_worker_input_bytes_total{stage=\"fill\"} 100000\n"));
}

TEST_F(WorkerTest, WritesALargeOutputAsABlob) {
  const auto large = [](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    return std::string(kInlineBlobBytes + 1, 'y');
  };
  const v1::BlobRef output = Run(large, TaskOf(1, "")).output();
  EXPECT_EQ(output.content(), "");
  EXPECT_EQ(output.size(), static_cast<int64_t>(kInlineBlobBytes + 1));
  EXPECT_EQ(coordinator_.Blob(output.digest()), std::string(kInlineBlobBytes + 1, 'y'));
  coordinator_.FailWrites(absl::ResourceExhaustedError("disk full"));
  EXPECT_EQ(StatusFromProto(Run(large, TaskOf(2, "")).error()), absl::ResourceExhaustedError("disk full"));
}

TEST_F(WorkerTest, SendsAResultAgainThatACutConnectionDidNotTake) {
  const StageRunner large = [](Stage, const std::string&, const CancelToken&) -> absl::StatusOr<std::string> {
    return std::string(kInlineBlobBytes + 1, 'y');
  };
  coordinator_.FailWrites(absl::UnavailableError("socket closed"), 2);
  const v1::FinishedTask report = Run(large, TaskOf(1, ""));
  ASSERT_TRUE(report.has_output()) << report.DebugString();
  EXPECT_EQ(coordinator_.Blob(report.output().digest()).size(), kInlineBlobBytes + 1);
  coordinator_.FailWrites(absl::UnavailableError("no room at the coordinator's"));
  EXPECT_TRUE(absl::IsUnavailable(StatusFromProto(Run(large, TaskOf(2, "")).error()))) << "but not for ever";
}

}  // namespace
}  // namespace tilemend
