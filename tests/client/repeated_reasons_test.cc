#include "client/repeated_reasons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> Shortened(std::vector<std::string> reasons) {
  std::vector<std::string*> pointers;
  for (std::string& reason : reasons) pointers.push_back(&reason);
  ShortenRepeated(pointers);
  return reasons;
}

const std::string kCrosses = "every patch that was tried passes through itself or the surface around it";

TEST(ShortenRepeatedTest, ALongReasonIsPrintedOnce) {
  EXPECT_THAT(Shortened({kCrosses, "14 % of the surface around it is no higher than its rim", kCrosses}),
              ElementsAre("[1] " + kCrosses, "14 % of the surface around it is no higher than its rim", "[1]"));
}

TEST(ShortenRepeatedTest, WhatDiffersIsKept) {
  EXPECT_THAT(Shortened({"its rim is too short: 19 places tell its level, 20 are needed", kCrosses,
                         "its rim is too short: 8 places tell its level, 20 are needed", kCrosses}),
              ElementsAre("[1] its rim is too short: 19 places tell its level, 20 are needed", "[2] " + kCrosses,
                          "[1] 8 places tell its level", "[2]"));
}

TEST(ShortenRepeatedTest, ShortOnesAndNoneStay) {
  EXPECT_THAT(Shortened({"no loop", "no loop", "", ""}), ElementsAre("no loop", "no loop", "", ""));
  EXPECT_TRUE(Shortened({}).empty());
}

TEST(ShortenRepeatedTest, OfATableTheLastColumn) {
  std::vector<std::vector<std::string>> rows = {{"1", kCrosses}, {"2", kCrosses}};
  ShortenRepeated(rows);
  EXPECT_THAT(rows, ElementsAre(ElementsAre("1", "[1] " + kCrosses), ElementsAre("2", "[1]")));
}

}  // namespace
}  // namespace tilemend
