#include "coordinator/jobs/task_reuse.h"

#include <gtest/gtest.h>

#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

class TaskReuseTest : public ::testing::Test {
 protected:
  TaskReuse NewJob() { return TaskReuse(ResultLog::Open(folder_ / "log", ResultLog::Opening::kNewJob).value()); }

  // Another job that does the task; gives whether it was known.
  static bool Do(TaskReuse& reuse, NewTask task, const std::string& output) {
    if (reuse.Recall(task, 0)) return true;
    auto result = DecodeResult({task.cell, task.stage, output});
    EXPECT_TRUE(result.ok()) << result.status();
    if (!result.ok()) return false;
    EXPECT_TRUE(reuse.Resolve(*result, 0).ok());
    EXPECT_TRUE(reuse.Keep(task.cell, task.stage, 0, result->bytes).ok());
    return false;
  }

  static NewTask Layer(double lattice_step = 0.5) {
    CellHoles holes;
    holes.lattice_step = lattice_step;
    v1::SampleLayerInput input;
    *input.mutable_holes() = ToProto(holes);
    return {{1, 2}, Stage::kSampleLayer, input.SerializeAsString()};
  }
  static NewTask Survey() {
    v1::SurveyInput input;
    input.mutable_tile()->set_path("a.ply");
    return {{1, 2}, Stage::kSurvey, input.SerializeAsString()};
  }
  static v1::SurveyOutput Surveyed() {
    v1::SurveyOutput output;
    output.set_digest(FileDigest("a"));
    output.mutable_witness()->set_digest(output.digest());
    output.set_vertex_count(5);
    return output;
  }

  const TemporaryFolder folder_;
};

TEST_F(TaskReuseTest, TakesOverWhatHasTheSameInput) {
  {
    TaskReuse first = NewJob();
    EXPECT_FALSE(Do(first, Layer(), ""));
  }
  TaskReuse second = NewJob();
  EXPECT_TRUE(Do(second, Layer(), ""));
  EXPECT_FALSE(Do(second, Layer(0.25), ""));
  EXPECT_EQ(second.tasks(), 2);
  EXPECT_EQ(second.taken_over(), 1);
  EXPECT_EQ(second.without_worker(), 1);
}

TEST_F(TaskReuseTest, WhatCannotBeTheResultIsAskedForAgain) {
  {
    TaskReuse first = NewJob();
    NewTask task = Layer();
    EXPECT_FALSE(first.Recall(task, 0));
    EXPECT_TRUE(first.Keep(task.cell, task.stage, 0, "no message \xff\xff").ok());
  }
  TaskReuse second = NewJob();
  EXPECT_FALSE(Do(second, Layer(), ""));
}

TEST_F(TaskReuseTest, ASurveyIsTakenOverWhenAWorkerHasFoundItsTileUnchanged) {
  {
    TaskReuse first = NewJob();
    Do(first, Survey(), Surveyed().SerializeAsString());
  }
  TaskReuse second = NewJob();
  NewTask task = Survey();
  EXPECT_FALSE(second.Recall(task, 0)) << "not without a look at the tile";
  v1::SurveyInput input;
  ASSERT_TRUE(input.ParseFromString(task.input));
  EXPECT_EQ(input.known().digest(), Surveyed().digest());
  v1::SurveyOutput unchanged;
  unchanged.set_digest(Surveyed().digest());
  unchanged.set_unchanged(true);
  StageResult result{task.cell, task.stage, unchanged.SerializeAsString(), unchanged, {}};
  ASSERT_TRUE(second.Resolve(result, 0).ok());
  EXPECT_EQ(result.bytes, Surveyed().SerializeAsString());
  EXPECT_EQ(std::get<v1::SurveyOutput>(result.output).SerializeAsString(), result.bytes);
  EXPECT_EQ(second.taken_over(), 1);
  EXPECT_EQ(second.without_worker(), 0);
}

TEST_F(TaskReuseTest, FilesOfWhichSomeWereMissingAreWrittenAgain) {
  v1::AssembleOutput written;
  written.add_files()->set_path("a.ply");
  for (const bool warned : {false, true}) {
    if (warned) written.add_warnings("an image is not there");
    const NewTask assemble{{1, warned}, Stage::kAssemble, ""};
    {
      TaskReuse first = NewJob();
      Do(first, assemble, written.SerializeAsString());
    }
    TaskReuse second = NewJob();
    NewTask task = assemble;
    EXPECT_FALSE(second.Recall(task, 0));
    v1::AssembleInput input;
    ASSERT_TRUE(input.ParseFromString(task.input));
    EXPECT_EQ(input.has_known(), !warned);
  }
}

TEST_F(TaskReuseTest, WithoutALogEverythingIsDone) {
  TaskReuse reuse(std::nullopt);
  EXPECT_FALSE(Do(reuse, Layer(), ""));
  EXPECT_FALSE(Do(reuse, Layer(), ""));
  EXPECT_EQ(reuse.tasks(), 2);
  EXPECT_TRUE(reuse.Finish().ok());
}

}  // namespace
}  // namespace tilemend
