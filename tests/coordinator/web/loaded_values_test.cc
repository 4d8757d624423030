#include "coordinator/web/loaded_values.h"

#include <gtest/gtest.h>

#include <semaphore>

namespace tilemend {
namespace {

using Ints = LoadedValues<int>;

Ints::Load Giving(int value, int* calls = nullptr) {
  return [=]() -> Ints::Result {
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
  const Ints::Load slow = [&]() -> Ints::Result {
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

TEST(LoadedValuesTest, TellsAnErrorAndLoadsAgain) {
  Ints values(2);
  EXPECT_TRUE(absl::IsNotFound(Await(values, "a", [] { return Ints::Result(absl::NotFoundError("a")); }).status()));
  EXPECT_EQ(**Await(values, "a", Giving(2)), 2);
}

}  // namespace
}  // namespace tilemend
