// One worker that took every task and began none starved two honest ones for 75 s.
#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr int kTasks = 12;
constexpr absl::Duration kMostStarving = absl::Seconds(6);

using IdleHoldersTest = StateTest;

TEST_F(IdleHoldersTest, DoNotStarveOthers) {
  AddJob("a", kTasks);
  See("greedy", 4096);
  for (int task = 1; task <= kTasks; ++task) Lease(Key("a", task), "greedy");
  for (const std::string worker : {"honest1", "honest2"}) See(worker, 2);
  EXPECT_THAT(Choose("honest1"), IsEmpty());
  now_ += kMostStarving;
  int done = 0;
  while (done < kTasks) {
    for (const std::string worker : {"honest1", "honest2"}) {
      const std::vector<TaskKey> chosen = Choose(worker);
      ASSERT_THAT(chosen, SizeIs(2));
      for (const TaskKey& key : chosen) Complete(key, worker, Lease(key, worker));
      done += 2;
    }
  }
  EXPECT_EQ(Counts("a").committed, kTasks);
}

TEST_F(IdleHoldersTest, WhatIsBegunStaysWithItsHolder) {
  AddJob("a", 1);
  See("busy");
  const uint64_t token = Lease(Key("a", 1), "busy");
  Do(LeaseRenewed{Key("a", 1), "busy", token, now_ + kLease, true});
  See("idle");
  now_ += kMostStarving;
  EXPECT_THAT(Choose("idle"), IsEmpty());
}

}  // namespace
}  // namespace tilemend
