#include "coordinator/api/waiting_syncs.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <string>
#include <vector>

#include "absl/time/clock.h"
#include "common/metrics/metrics.h"
#include "coordinator/journal/journal.h"

namespace tilemend {
namespace {

using std::chrono::steady_clock;

CoordinatorOptions InMemory() {
  CoordinatorOptions options;
  options.clock = [] { return absl::Now(); };
  options.journal = NewForgetfulJournal();
  return options;
}

// Calls that end when they are due, or when the test says so.
class WaitingSyncsTest : public ::testing::Test {
 protected:
  std::shared_ptr<WorkerSync> Add(const std::string& worker, steady_clock::duration wait) {
    auto sync = std::make_shared<WorkerSync>();
    sync->request.set_worker(worker);
    sync->deadline = steady_clock::now() + wait;
    const ClusterLock lock(cluster_.mutex);
    waiting_.Add(sync);
    return sync;
  }

  // The next call that ends.
  std::string NextEnd() {
    ClusterLock lock(cluster_.mutex);
    EXPECT_TRUE(ended_changed_.wait_for(lock, std::chrono::seconds(60), [&] { return !ended_.empty(); }));
    if (ended_.empty()) return "none";
    std::string worker = ended_.front();
    ended_.erase(ended_.begin());
    return worker;
  }

  void EndAll() {
    const ClusterLock lock(cluster_.mutex);
    all_end_ = true;
    cluster_.work_changed.notify_all();
  }

  bool Try(const std::shared_ptr<WorkerSync>& sync) {
    if (!all_end_ && sync->request.worker() != ends_ && steady_clock::now() < sync->deadline) return false;
    ended_.push_back(sync->request.worker());
    ended_changed_.notify_all();
    return true;
  }

  Cluster cluster_{InMemory(), *MetricsRegistry::Null()};
  bool all_end_ = false;  // with the lock, as what follows
  std::string ends_;
  std::vector<std::string> ended_;
  std::condition_variable ended_changed_;
  WaitingSyncs waiting_{cluster_, [this](const std::shared_ptr<WorkerSync>& sync) { return Try(sync); }};
};

TEST_F(WaitingSyncsTest, EndsWhatIsDueWhateverCameBefore) {
  Add("late", std::chrono::hours(1));
  Add("soon", std::chrono::milliseconds(20));
  EXPECT_EQ(NextEnd(), "soon");
  EndAll();
  EXPECT_EQ(NextEnd(), "late");
}

TEST_F(WaitingSyncsTest, TriesAllWhenWorkHasChanged) {
  Add("a", std::chrono::hours(1));
  Add("b", std::chrono::hours(1));
  EndAll();
  EXPECT_EQ(NextEnd(), "a");
  EXPECT_EQ(NextEnd(), "b");
}

TEST_F(WaitingSyncsTest, LooksAtTheCallsOfOneWorker) {
  Add("a", std::chrono::hours(1));
  Add("b", std::chrono::hours(1));
  {
    const ClusterLock lock(cluster_.mutex);
    ends_ = "b";
    waiting_.TryCallsOf("a");
    EXPECT_TRUE(ended_.empty());
    waiting_.TryCallsOf("b");
    EXPECT_EQ(ended_, std::vector<std::string>{"b"});
    waiting_.TryCallsOf("b");  // which does not wait any more
    EXPECT_EQ(ended_.size(), 1U);
    ended_.clear();
  }
  EndAll();
  EXPECT_EQ(NextEnd(), "a");
}

}  // namespace
}  // namespace tilemend
