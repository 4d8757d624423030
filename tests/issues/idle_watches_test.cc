// 500 watches of a job that does nothing hung every client that wanted to watch another, for as long as they stayed.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <iostream>
#include <thread>
#include <vector>

#include "tests/support/test_cluster.h"

namespace tilemend {
namespace {

constexpr int kIdle = 600;  // more than the coordinator has at once
constexpr double kMostSeconds = 10;

TEST(IdleWatchesTest, MakeRoomForANewOne) {
  TestCluster cluster;
  WatchHandler& watches = cluster.coordinator().calls().watch;
  v1::WatchJobRequest watch;
  watch.set_name(cluster.Submit("toy://2x1").name());  // there is no worker
  std::atomic<int> refused{0}, told{0};
  std::atomic<bool> is_over{false};
  const auto idle = [&] {
    const auto send = [&](const v1::Job&) {
      ++told;
      return true;
    };
    const auto go_on = [&] { return is_over ? absl::CancelledError("over") : absl::OkStatus(); };
    if (absl::IsResourceExhausted(watches.WatchJob(watch, send, go_on))) ++refused;
  };
  std::vector<std::jthread> callers;
  for (int i = 0; i < kIdle; ++i) {
    callers.emplace_back(idle);
    while (told + refused <= i) std::this_thread::yield();
  }
  const auto start = std::chrono::steady_clock::now();
  int states = 0;
  const absl::Status status = watches.WatchJob(
      watch, [&](const v1::Job&) { return ++states == 0; }, [] { return absl::OkStatus(); });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  is_over = true;
  std::cout << kIdle << " idle watches, " << refused << " refused; a new one is told after " << took.count() << " s\n";
  EXPECT_TRUE(absl::IsCancelled(status)) << status;
  EXPECT_EQ(states, 1);
  EXPECT_EQ(refused, 0);
  EXPECT_LT(took.count(), kMostSeconds);
}

}  // namespace
}  // namespace tilemend
