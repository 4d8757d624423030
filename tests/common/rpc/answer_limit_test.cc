#include "common/rpc/answer_limit.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using std::chrono::seconds;

TEST(AnswerLimitTest, CancelsWhatTakesTooLong) {
  AnswerLimit limit(seconds(30));
  const AnswerLimit::Time start;
  int early = 0, late = 0, over = 0;
  limit.Begin(
      &early, [&] { ++early; }, start);
  limit.Begin(
      &late, [&] { ++late; }, start + seconds(20));
  limit.Begin(
      &over, [&] { ++over; }, start);
  EXPECT_TRUE(limit.End(&over));
  EXPECT_FALSE(limit.End(&over));
  EXPECT_EQ(limit.CancelDue(start + seconds(29)), 0U);
  EXPECT_EQ(limit.CancelDue(start + seconds(30)), 1U);
  EXPECT_EQ(limit.CancelDue(start + seconds(49)), 1U) << "until it is over";
  EXPECT_EQ(early, 2);
  EXPECT_EQ(late, 0);
  EXPECT_EQ(over, 0);
}

TEST(AnswerLimitTest, ACallThatBeginsAgainHasItsTimeAgain) {
  AnswerLimit limit(seconds(30));
  const AnswerLimit::Time start;
  int cancelled = 0;
  limit.Begin(
      &cancelled, [&] { ++cancelled; }, start);
  limit.End(&cancelled);
  limit.Begin(
      &cancelled, [&] { ++cancelled; }, start + seconds(100));
  EXPECT_EQ(limit.CancelDue(start + seconds(120)), 0U);
  EXPECT_EQ(limit.CancelDue(start + seconds(130)), 1U);
  limit.End(&cancelled);
  EXPECT_EQ(limit.CancelDue(start + seconds(999)), 0U);
}

}  // namespace
}  // namespace tilemend
