// 500 watches of a job that does nothing hung every client that wanted to watch another, for as long as they stayed.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <iostream>
#include <memory>

#include "tests/support/test_cluster.h"
#include "tests/support/waiting_watch.h"

namespace tilemend {
namespace {

constexpr int kIdle = 5000;  // more than the coordinator has at once
constexpr double kMostSeconds = 10;

class IdleWatcher : public Watcher {
 public:
  IdleWatcher(WatchHandler& watches, std::atomic<int>& over) : watches_(watches), over_(over) {}
  absl::Status Begin(const v1::WatchJobRequest& request) { return watches_.WatchJob(request, watch_); }

 private:
  absl::Status GoOn() override { return absl::OkStatus(); }
  void Send(const WatchNews&) override { watches_.Sent(watch_); }
  void End(const absl::Status& status) override {
    EXPECT_TRUE(status.ok() || absl::IsUnavailable(status)) << status;
    const auto kept = std::move(watch_);  // as a call does that is over: the coordinator may count it no more
    ++over_;
  }

  WatchHandler& watches_;
  std::atomic<int>& over_;
  std::shared_ptr<Watch> watch_ = NewWatch(*this);
};

TEST(IdleWatchesTest, MakeRoomForANewOne) {
  std::atomic<int> over{0};
  std::deque<IdleWatcher> idle;  // outlives the cluster
  TestCluster cluster;
  WatchHandler& watches = cluster.coordinator().calls().watch;
  v1::WatchJobRequest watch;
  watch.set_name(cluster.Submit("toy://2x1").name());  // there is no worker
  for (int i = 0; i < kIdle; ++i) {
    const absl::Status begun = idle.emplace_back(watches, over).Begin(watch);
    EXPECT_TRUE(begun.ok()) << begun;
  }
  const auto start = std::chrono::steady_clock::now();
  int states = 0;
  const absl::Status status = WatchAndWait(watches, watch, [&](const v1::Job&) { return ++states == 0; });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << kIdle << " idle watches, " << over << " gave way; a new one is told after " << took.count() << " s\n";
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
  EXPECT_EQ(states, 1);
  EXPECT_GT(over, 0);
  EXPECT_LT(over, kIdle / 2);
  EXPECT_LT(took.count(), kMostSeconds);
}

}  // namespace
}  // namespace tilemend
