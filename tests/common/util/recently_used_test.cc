#include "common/util/recently_used.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

class RecentlyUsedTest : public testing::Test {
 protected:
  void Put(const std::string& key, int value, size_t bytes) {
    recent_.Put(key, std::make_shared<const int>(value), bytes);
  }
  // -1: it is not there.
  int Find(const std::string& key) {
    const auto found = recent_.Find(key);
    return found == nullptr ? -1 : *found;
  }

  RecentlyUsed<std::string, int> recent_{10};
};

TEST_F(RecentlyUsedTest, ForgetsWhatWasUsedLongestAgo) {
  Put("a", 1, 4);
  Put("b", 2, 4);
  EXPECT_EQ(Find("a"), 1);
  Put("c", 3, 4);
  EXPECT_EQ(Find("a"), 1);
  EXPECT_EQ(Find("b"), -1);
  EXPECT_EQ(Find("c"), 3);
}

TEST_F(RecentlyUsedTest, TakesTheNewOneInPlaceOfTheOld) {
  Put("a", 1, 8);
  Put("a", 2, 2);
  Put("b", 3, 8);
  EXPECT_EQ(Find("a"), 2);
  EXPECT_EQ(Find("b"), 3);
}

TEST_F(RecentlyUsedTest, KeepsNothingThatIsLargerThanItself) {
  Put("a", 1, 11);
  EXPECT_EQ(Find("a"), -1);
  Put("b", 2, 10);
  EXPECT_EQ(Find("b"), 2);
}

}  // namespace
}  // namespace tilemend
