#include "coordinator/journal/group_commit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tilemend {
namespace {

TEST(GroupCommitTest, CommitsInOrderBeforeAwaitReturns) {
  std::vector<int64_t> committed;
  GroupCommit commits(
      [&](const std::vector<JournalPut>& puts) {
        for (const JournalPut& put : puts) committed.push_back(std::get<OldJob>(put).number);
      },
      [] { return false; });
  for (int64_t i = 0; i < 100; ++i) commits.Put(OldJob{i});
  commits.Await();
  ASSERT_EQ(committed.size(), 100U);
  for (int64_t i = 0; i < 100; ++i) EXPECT_EQ(committed[i], i);
}

TEST(GroupCommitTest, CommitsWhatWasPutBeforeItEnds) {
  size_t committed = 0;
  {
    GroupCommit commits([&](const std::vector<JournalPut>& puts) { committed += puts.size(); }, [] { return false; });
    commits.Put(OldJob{1});
  }
  EXPECT_EQ(committed, 1U);
}

TEST(GroupCommitTest, TidiesUpWhileThereIsNothingToCommit) {
  std::atomic<int> left{3};
  GroupCommit commits([](const std::vector<JournalPut>&) {},
                      [&] {
                        --left;
                        left.notify_all();
                        return left > 0;
                      });
  for (int now = left; now > 0; now = left) left.wait(now);
  EXPECT_EQ(left, 0);
}

}  // namespace
}  // namespace tilemend
