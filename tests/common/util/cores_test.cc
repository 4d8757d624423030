#include "common/util/cores.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace tilemend {
namespace {

TEST(CoresTest, AreHeldByAsManyThreadsAsThereAre) {
  Cores cores(2);
  std::atomic<int> now = 0, most = 0, runs = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 100; ++i) {
        const Cores::Held held(cores);
        const int here = ++now;
        int seen = most;
        while (here > seen && !most.compare_exchange_weak(seen, here)) {
        }
        std::this_thread::yield();
        --now;
        ++runs;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(runs, 800);
  EXPECT_LE(most, 2);
}

TEST(CoresTest, AnotherHasTheCoreWhileItIsLent) {
  Cores cores(1);
  std::promise<void> is_lent, was_used;
  std::atomic<bool> is_back = false;
  std::thread lender([&] {
    const Cores::Held held(cores);
    {
      const LentCore lent;
      is_lent.set_value();
      was_used.get_future().wait();
    }
    is_back = true;
  });
  is_lent.get_future().wait();
  {
    const Cores::Held held(cores);
    was_used.set_value();
    EXPECT_FALSE(is_back);
  }
  lender.join();
  EXPECT_TRUE(is_back);
}

TEST(CoresTest, AThreadWithoutOneLendsNothing) {
  Cores cores(1);
  { const LentCore lent; }
  {
    const Cores::Held held(cores);
    const LentCore lent;
    const LentCore again;  // it is lent already
  }
  const Cores::Held held(cores);
}

}  // namespace
}  // namespace tilemend
