#include "worker/service/verify_stage.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/rpc/receipt_payloads.h"
#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {
namespace {

class VerifyStageTest : public ::testing::Test {
 protected:
  absl::StatusOr<v1::VerifyOutput> Run(const CancelToken& cancel = CancelToken()) {
    const auto bytes = RunVerify(input_, cancel, memory_, compute_);
    if (!bytes.ok()) return bytes.status();
    v1::VerifyOutput output;
    EXPECT_TRUE(output.ParseFromString(*bytes));
    return output;
  }

  const TemporaryFolder folder_;
  TaskMemory memory_{std::numeric_limits<int64_t>::max()};
  v1::VerifyInput input_;
  const ComputeStage compute_ = [](Stage stage, const std::string& input) {
    return absl::StatusOr<std::string>(std::string(StageName(stage)) + " " + input);
  };
};

TEST_F(VerifyStageTest, GivesTheDigestsOfFilesThenOfTiles) {
  const std::string file = folder_.Write("out/a.png", "image");
  folder_.Write("scene/a.ply", "tile");
  input_.add_paths(file);
  input_.add_tiles()->set_root(folder_ / "scene");
  input_.mutable_tiles(0)->set_path("a.ply");
  const auto output = Run();
  ASSERT_TRUE(output.ok()) << output.status();
  ASSERT_EQ(output->files_size(), 2);
  EXPECT_EQ(output->files(0).digest(), FileDigest("image"));
  EXPECT_EQ(FromProto(output->files(0).receipt()), ReceiptOf(file).value());
  EXPECT_EQ(output->files(1).digest(), FileDigest("tile"));
}

TEST_F(VerifyStageTest, AFileThatIsNotThereIsForAnotherMachine) {
  input_.add_paths(folder_ / "none");
  EXPECT_TRUE(absl::IsUnavailable(Run().status()));
}

TEST_F(VerifyStageTest, ComputesATaskAgain) {
  v1::RepeatedTask& task = *input_.add_tasks();
  task.set_stage(v1::FILL);
  task.set_input("holes");
  EXPECT_EQ(Run()->files(0).digest(), FileDigest("fill holes"));
  for (const v1::Stage stage : {v1::ASSEMBLE, v1::VERIFY}) {
    task.set_stage(stage);
    EXPECT_TRUE(absl::IsInvalidArgument(Run().status()));
  }
}

TEST_F(VerifyStageTest, StopsWhenItIsCancelled) {
  input_.add_paths(folder_.Write("a", "a"));
  CancelToken cancel;
  cancel.Cancel();
  EXPECT_TRUE(absl::IsCancelled(Run(cancel).status()));
}

}  // namespace
}  // namespace tilemend
