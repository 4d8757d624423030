// Three healthy workers that stood still for longer than their lease, one after another, quarantined a cell.
#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using FrozenWorkersTest = StateTest;

TEST_F(FrozenWorkersTest, TakeTheirLossBackWhenTheyAreThereAgain) {
  AddJob("a", 1);
  for (const std::string worker : {"w1", "w2", "w3", "w4"}) {
    See(worker);
    Lease(Key("a", 1), worker);
    EXPECT_THAT(Do(WorkerLost{worker}).settled, IsEmpty()) << worker << " quarantined the cell";
    const Effects back = Do(WorkerSeen{worker, 1, false, now_});
    ASSERT_THAT(back.relieved, SizeIs(1));
    EXPECT_EQ(back.relieved[0].key, Key("a", 1));
    EXPECT_THAT(back.relieved[0].lost_workers, IsEmpty());
  }
  Complete(Key("a", 1), "w1", Lease(Key("a", 1), "w1"));
  Do(JobFinished{"a", JobState::kDone, now_});
  EXPECT_EQ(state_.FindJob("a")->state, JobState::kDone);
}

TEST_F(FrozenWorkersTest, ThoseThatStayAwayCount) {
  AddJob("a", 1);
  for (const std::string worker : {"w1", "w2"}) {
    See(worker);
    Lease(Key("a", 1), worker);
    Do(WorkerLost{worker});
  }
  See("w2");
  EXPECT_THAT(state_.FindTask(Key("a", 1))->lost_workers, ElementsAre("w1"));
}

// A task that ends workers which are started again under the same name.
TEST_F(FrozenWorkersTest, ComingBackAgainAndAgainEndsAllTheSame) {
  AddJob("a", 1);
  int losses = 0;
  while (state_.FindTask(Key("a", 1)) != nullptr && losses < 20) {
    See("w");
    Lease(Key("a", 1), "w");
    Do(WorkerLost{"w"});
    ++losses;
  }
  EXPECT_EQ(losses, 9);
  EXPECT_EQ(Counts("a").quarantined, 1);
}

}  // namespace
}  // namespace tilemend
