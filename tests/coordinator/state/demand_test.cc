#include "coordinator/state/demand.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

const absl::Time kNow = absl::FromUnixSeconds(1000);

class DemandTest : public ::testing::Test {
 protected:
  void Do(const Event& event) { ASSERT_TRUE(state_.Apply(event).ok()); }
  void AddJob(const std::string& id, size_t tasks) {
    Do(JobCreated{id, "", kNow});
    Do(TasksAdded{id, std::vector<TaskSpec>(tasks)});
  }
  CoordinatorState state_;
};

TEST_F(DemandTest, NothingIsWantedWithoutAJob) { EXPECT_EQ(DemandOf(state_), Demand()); }

TEST_F(DemandTest, AJobBetweenItsTasksIsStillThere) {
  AddJob("a", 0);
  EXPECT_EQ(DemandOf(state_), (Demand{1, 0}));
}

TEST_F(DemandTest, TasksThatWaitAndThatRunCountAndSettledOnesDoNot) {
  AddJob("a", 3);
  AddJob("b", 2);
  Do(WorkerSeen{"w", 2, false, kNow});
  const TaskKey first{"a", 1}, second{"a", 2};
  Do(TaskLeased{first, "w", 7, kNow, kNow + absl::Seconds(30)});
  Do(TaskLeased{second, "w", 8, kNow, kNow + absl::Seconds(30)});
  EXPECT_EQ(DemandOf(state_), (Demand{2, 5}));
  Do(TaskCompleted{first, "w", 7, "digest", kNow});
  EXPECT_EQ(DemandOf(state_), (Demand{2, 4}));
  Do(JobCancelled{"b", kNow});
  EXPECT_EQ(DemandOf(state_), (Demand{1, 2}));
}

}  // namespace
}  // namespace tilemend
