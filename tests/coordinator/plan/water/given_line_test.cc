#include "coordinator/plan/water/given_line.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/rims.h"

namespace tilemend {
namespace {

std::vector<PlaneSegment> BoxOutline(const Point2& lo, const Point2& hi) {
  return BoxRim(lo, hi, [](double, double) { return 0; }).outline;
}

TEST(RunsThroughTest, WhatALineCrossesOrLiesIn) {
  const std::vector<Point2> line = {{0, 0}, {250, 0}, {500, 0}};
  EXPECT_TRUE(RunsThrough(line, BoxOutline({100, -15}, {200, 15})));
  EXPECT_TRUE(RunsThrough(line, BoxOutline({-50, -40}, {550, 40})));
  EXPECT_FALSE(RunsThrough(line, BoxOutline({100, 20}, {200, 40})));
  EXPECT_FALSE(RunsThrough(line, BoxOutline({510, -15}, {600, 15})));
}

TEST(WhereItTurnsBackTest, FindsTheVertex) {
  const std::vector<Point2> line = {{0, 0}, {10, 0}, {20, 1}, {20, 1}, {11, 0}, {30, 0}};
  EXPECT_EQ(WhereItTurnsBack(line), Point2(20, 1));
}

TEST(WhereItTurnsBackTest, MeandersDoNot) {
  EXPECT_FALSE(WhereItTurnsBack(std::vector<Point2>{{0, 0}, {10, 0}, {20, 0}, {20, 10}, {10, 12}, {0, 12}}));
  EXPECT_FALSE(WhereItTurnsBack(std::vector<Point2>{{0, 0}, {10, 0}, {3, 7}, {12, 20}}));
  EXPECT_FALSE(WhereItTurnsBack({}));
}

}  // namespace
}  // namespace tilemend
