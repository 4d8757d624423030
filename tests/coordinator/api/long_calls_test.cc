#include "coordinator/api/long_calls.h"

#include <gtest/gtest.h>

#include "common/util/error_info.h"

namespace tilemend {
namespace {

const absl::Time kStart = absl::FromUnixSeconds(1000);

bool Never(const std::string&) { return false; }

TEST(LongCallsTest, RefusesTooManyAndTakesOthersLater) {
  LongCalls calls(2);
  auto first = calls.Enter("a", kStart, [] {});
  const auto second = calls.Enter("a", kStart, [] {});
  EXPECT_EQ(ErrorReason(calls.Enter("a", kStart, [] {}).status()), "TOO_MANY_CALLS");
  first->reset();
  EXPECT_TRUE(calls.Enter("a", kStart, [] {}).ok());
}

TEST(LongCallsTest, AFurtherOneMayTakeThePlaceOfTheOldest) {
  LongCalls calls(2, LongCalls::WhenFull::kStopOldest);
  int old = 0, busy = 0;
  auto first = calls.Enter("a", kStart, [&] { ++old; });
  const auto second = calls.Enter("a", kStart, [&] { ++busy; });
  (*second)->Touch(kStart + absl::Seconds(1));
  auto third = calls.Enter("a", kStart + absl::Seconds(2), [] {});
  EXPECT_TRUE(third.ok());
  EXPECT_EQ(old, 1);
  EXPECT_EQ(busy, 0);
  const auto fourth = calls.Enter("a", kStart + absl::Seconds(2), [] {});
  EXPECT_EQ(busy, 1);
  EXPECT_EQ(ErrorReason(calls.Enter("a", kStart, [] {}).status()), "TOO_MANY_CALLS");  // until those two have ended
  first->reset();
  EXPECT_TRUE(calls.Enter("a", kStart, [] {}).ok());
}

TEST(LongCallsTest, StopsWhatDoesNotGetOn) {
  LongCalls calls(9);
  int idle = 0, busy = 0;
  const auto one = calls.Enter("a", kStart, [&] { ++idle; });
  const auto two = calls.Enter("a", kStart, [&] { ++busy; });
  (*two)->Touch(kStart + absl::Seconds(50));
  calls.Stop(kStart + absl::Seconds(20), Never);
  EXPECT_EQ(idle, 1);
  EXPECT_EQ(busy, 0);
}

TEST(LongCallsTest, StopsThoseOfJobsThatAreOver) {
  LongCalls calls(9);
  int over = 0, running = 0;
  auto one = calls.Enter("over", kStart, [&] { ++over; });
  const auto two = calls.Enter("running", kStart, [&] { ++running; });
  const auto is_over = [](const std::string& job) { return job == "over"; };
  calls.Stop(kStart, is_over);
  one->reset();
  calls.Stop(kStart, is_over);
  EXPECT_EQ(over, 1);
  EXPECT_EQ(running, 0);
}

}  // namespace
}  // namespace tilemend
