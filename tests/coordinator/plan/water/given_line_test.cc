#include "coordinator/plan/water/given_line.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

constexpr double kTolerance = 0.1;

// From (x0, y0) to (x1, y1), a shore point every metre, at a level of 10 that falls by 1 mm a metre eastward, or
// `above` it, with the centreline along y = 0.
Reach BoxOfWater(double x0, double y0, double x1, double y1, double above = 0) {
  Reach reach;
  std::vector<Point2> ring;
  for (double x = x0; x < x1; ++x) ring.emplace_back(x, y0);
  for (double y = y0; y < y1; ++y) ring.emplace_back(x1, y);
  for (double x = x1; x > x0; --x) ring.emplace_back(x, y1);
  for (double y = y1; y > y0; --y) ring.emplace_back(x0, y);
  for (size_t i = 0; i < ring.size(); ++i) {
    reach.boundary.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    reach.shore.emplace_back(ring[i].x(), ring[i].y(), 10 - 0.001 * ring[i].x() + above);
  }
  reach.bank.assign(ring.size(), 11);
  reach.forced = true;
  reach.centreline = {{0, 0}, {250, 0}, {500, 0}};
  return reach;
}

std::vector<bool> HaveTheLine(std::vector<Reach> reaches) {
  LeaveOtherWater(kTolerance, reaches);
  std::vector<bool> have;
  for (const Reach& reach : reaches) have.push_back(!reach.centreline.empty());
  return have;
}

using Have = std::vector<bool>;

TEST(LeaveOtherWaterTest, ALakeBesideTheLineIsNoPartOfItsRiver) {
  const Reach river = BoxOfWater(0, -15, 500, 15);
  for (const double above : {0.7, -0.7}) {
    EXPECT_EQ(HaveTheLine({river, BoxOfWater(100, 40, 160, 100, above)}), (Have{true, false})) << above;
  }
}

TEST(LeaveOtherWaterTest, WhatHasTheLevelOfTheRiverIsAPart) {
  EXPECT_EQ(HaveTheLine({BoxOfWater(100, 40, 160, 100), BoxOfWater(0, -15, 500, 15)}), (Have{true, true}));
}

TEST(LeaveOtherWaterTest, AShoreOfFewPointsTellsNothing) {
  EXPECT_EQ(HaveTheLine({BoxOfWater(0, -15, 500, 15), BoxOfWater(100, 40, 104, 44, 0.7)}), (Have{true, true}));
}

TEST(LeaveOtherWaterTest, WhatTheLineRunsThroughIsAPartWhateverItsLevel) {
  EXPECT_EQ(HaveTheLine({BoxOfWater(0, -15, 240, 15), BoxOfWater(260, -15, 500, 15, 0.7)}), (Have{true, true}));
  Reach around = BoxOfWater(-50, -40, 550, 40, 0.7);
  EXPECT_EQ(HaveTheLine({BoxOfWater(0, -15, 500, 15), around}), (Have{true, true}));
}

TEST(LeaveOtherWaterTest, ALineThatRunsThroughNothingIsKept) {
  EXPECT_EQ(HaveTheLine({BoxOfWater(0, 20, 500, 40), BoxOfWater(0, 50, 90, 90, 0.7)}), (Have{true, true}));
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
