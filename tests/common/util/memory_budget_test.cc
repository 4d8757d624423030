#include "common/util/memory_budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace tilemend {
namespace {

TEST(MemoryBudgetTest, SharesFitBesideEachOther) {
  MemoryBudget budget(10);
  const MemoryBudget::Share a(budget, 4), b(budget, 6), none(budget, 0);
}

TEST(MemoryBudgetTest, WhatDoesNotFitWaitsForOthersToGo) {
  MemoryBudget budget(10);
  auto first = std::make_unique<MemoryBudget::Share>(budget, 7);
  std::atomic<bool> is_in{false};
  std::thread second([&] {
    const MemoryBudget::Share share(budget, 4);
    is_in = true;
  });
  std::this_thread::yield();
  EXPECT_FALSE(is_in);
  first.reset();
  second.join();
  EXPECT_TRUE(is_in);
}

TEST(MemoryBudgetTest, OneThatIsTooLargeGoesInAlone) {
  MemoryBudget budget(10);
  { const MemoryBudget::Share share(budget, 1000); }
  const MemoryBudget::Share share(budget, 10);
}

TEST(MemoryBudgetTest, NeverGivesMoreThanThereIs) {
  MemoryBudget budget(10);
  std::atomic<int> taken{0}, most{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < 500; ++round) {
        const int bytes = 3 + t;
        const MemoryBudget::Share share(budget, bytes);
        const int now = taken += bytes;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        taken -= bytes;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_LE(most, 10);
  EXPECT_GT(most, 3);
}

}  // namespace
}  // namespace tilemend
