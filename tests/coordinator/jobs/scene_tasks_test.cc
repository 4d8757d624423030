#include "coordinator/jobs/scene_tasks.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "tests/coordinator/jobs/scene_tasks_fixture.h"

namespace tilemend {
namespace {

using SceneTasksTest = SceneTasksFixture;

TEST_F(SceneTasksTest, TellsTasksOfOneCellAndStageApart) {
  spec_.set_surface("wang");
  Begin();
  std::set<std::tuple<Stage, CellId, int32_t>> made;
  std::vector<NewTask> open;
  while (true) {
    while (auto work = waves_->Next()) {
      open.push_back(tasks_->TaskOf(*work).value());
      EXPECT_TRUE(made.emplace(open.back().stage, open.back().cell, tasks_->NumberOf(open.back())).second);
    }
    if (open.empty()) break;
    const NewTask task = open.back();
    open.pop_back();
    ASSERT_TRUE(tasks_
                    ->Take(DecodeResult({task.cell, task.stage,
                                         SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken())})
                               .value())
                    .ok());
  }
  EXPECT_TRUE(waves_->done());
}

TEST_F(SceneTasksTest, AResultThatCannotBeReadSaysWhichCell) {
  Begin();
  const absl::Status status = tasks_->Take({{2, 1}, Stage::kSampleCluster, "", v1::SampleClusterOutput(), {}});
  EXPECT_TRUE(absl::IsInternal(status));
  EXPECT_NE(status.message().find("2"), std::string::npos) << status;
}

}  // namespace
}  // namespace tilemend
