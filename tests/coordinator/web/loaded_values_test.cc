#include "coordinator/web/loaded_values.h"

#include <gtest/gtest.h>

#include <atomic>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

namespace tilemend {
namespace {

using Ints = LoadedValues<int>;

Ints::Load Giving(int value, int* calls = nullptr) {
  return [=](const std::stop_token&) -> Ints::Result {
    if (calls != nullptr) ++*calls;
    return std::make_shared<const int>(value);
  };
}

// Asks until it is there.
Ints::Result Await(Ints& values, const std::string& name, const Ints::Load& load) {
  Ints::Result result = values.Find(name, load);
  while (absl::IsUnavailable(result.status())) result = values.Find(name, load);
  return result;
}

TEST(LoadedValuesTest, LoadsOnce) {
  Ints values(2);
  int calls = 0;
  EXPECT_EQ(**Await(values, "a", Giving(7, &calls)), 7);
  EXPECT_EQ(**values.Find("a", Giving(8, &calls)), 7);
  EXPECT_EQ(calls, 1);
}

TEST(LoadedValuesTest, DoesNotWaitForWhatTakesLong) {
  std::binary_semaphore go(0);
  Ints values(2);
  const Ints::Load slow = [&](const std::stop_token&) -> Ints::Result {
    go.acquire();
    return std::make_shared<const int>(1);
  };
  EXPECT_TRUE(absl::IsUnavailable(values.Find("slow", slow).status()));
  EXPECT_TRUE(absl::IsUnavailable(values.Find("slow", slow).status()));
  go.release();
  EXPECT_EQ(**Await(values, "slow", slow), 1);
}

TEST(LoadedValuesTest, KeepsThoseThatWereAskedForLast) {
  Ints values(2);
  EXPECT_TRUE(Await(values, "a", Giving(1)).ok());
  EXPECT_TRUE(Await(values, "b", Giving(5)).ok());
  EXPECT_EQ(**Await(values, "a", Giving(9)), 1);
  values.Keep("c", std::make_shared<const int>(3));
  EXPECT_EQ(**Await(values, "c", Giving(9)), 3);
  EXPECT_EQ(**Await(values, "a", Giving(9)), 1);
  EXPECT_EQ(**Await(values, "b", Giving(2)), 2);  // was dropped
}

// More callers than there is room for, each of which asks again a little later: each gets its value.
TEST(LoadedValuesTest, GivesEachOfTooManyItsTurn) {
  Ints values(2);
  int calls = 0;
  int told = 0;
  std::vector<bool> has(5, false);
  for (int round = 0; round < 50 && told < 5; ++round) {
    for (int k = 0; k < 5; ++k) {
      const Ints::Load slow = [&calls, k](const std::stop_token&) -> Ints::Result {
        std::this_thread::sleep_for(kLoadingPatience * 2);
        ++calls;
        return std::make_shared<const int>(k);
      };
      const auto value = values.Find(std::to_string(k), slow);
      if (!value.ok() || has[k]) continue;
      EXPECT_EQ(**value, k);
      has[k] = true;
      ++told;
    }
  }
  EXPECT_EQ(told, 5);
}

// What nobody has got yet makes no room, so the queue has a bound.
TEST(LoadedValuesTest, RefusesMoreThanThereIsRoomFor) {
  std::counting_semaphore<8> go(0);
  std::atomic<int> calls = 0;
  Ints values(2);
  const Ints::Load slow = [&](const std::stop_token&) -> Ints::Result {
    ++calls;
    go.acquire();
    return std::make_shared<const int>(1);
  };
  for (int round = 0; round < 3; ++round) {
    for (const char* name : {"a", "b", "c", "d"}) EXPECT_TRUE(absl::IsUnavailable(values.Find(name, slow).status()));
  }
  go.release(8);
  EXPECT_EQ(**Await(values, "a", slow), 1);
  EXPECT_EQ(**Await(values, "b", slow), 1);
  EXPECT_EQ(calls, 2);
}

TEST(LoadedValuesTest, TellsAnErrorAndLoadsAgain) {
  Ints values(2);
  const Ints::Load failing = [](const std::stop_token&) { return Ints::Result(absl::NotFoundError("a")); };
  EXPECT_TRUE(absl::IsNotFound(Await(values, "a", failing).status()));
  EXPECT_EQ(**Await(values, "a", Giving(2)), 2);
}

TEST(LoadedValuesTest, ItsEndStopsWhatIsLoaded) {
  std::binary_semaphore begun(0);
  bool was_stopped = false;
  {
    Ints values(2);
    const Ints::Load endless = [&](const std::stop_token& stop) -> Ints::Result {
      begun.release();
      while (!stop.stop_requested()) std::this_thread::yield();
      was_stopped = true;
      return absl::CancelledError("stopped");
    };
    EXPECT_TRUE(absl::IsUnavailable(values.Find("a", endless).status()));
    begun.acquire();
  }
  EXPECT_TRUE(was_stopped);
}

}  // namespace
}  // namespace tilemend
