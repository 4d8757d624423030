#include "common/mesh/outline_crossing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tilemend {
namespace {

TEST(OutlineCrossingTest, ABowTieCrossesItselfInItsMiddle) {
  const auto crossing = FindCrossing({{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}});
  ASSERT_TRUE(crossing.has_value());
  EXPECT_EQ(crossing->at, Point2(5, 5));
  EXPECT_EQ(TextOf(*crossing), "ring 0 crosses itself at (5, 5), where the edges from positions 0 and 2 meet");
}

TEST(OutlineCrossingTest, IsFoundWhereverTheOutlineLiesAndBegins) {
  const std::vector<Point2> bow_tie = {{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  for (size_t start = 0; start < bow_tie.size(); ++start) {
    for (const double turn : {0.0, 0.3, 1.2, 2.9}) {
      std::vector<Point2> ring;
      for (size_t i = 0; i < bow_tie.size(); ++i) {
        const Point2 p = bow_tie[(start + i) % bow_tie.size()];
        ring.emplace_back(691000 + p.x() * std::cos(turn) - p.y() * std::sin(turn),
                          5335000 + p.x() * std::sin(turn) + p.y() * std::cos(turn));
      }
      EXPECT_TRUE(FindCrossing({{ring}}).has_value()) << start << " " << turn;
    }
  }
}

TEST(OutlineCrossingTest, PartsThatOverlapCross) {
  const std::vector<Point2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const std::vector<Point2> beside = {{5, 5}, {15, 5}, {15, 15}, {5, 15}};
  const auto crossing = FindCrossing({{square, beside}});
  ASSERT_TRUE(crossing.has_value());
  EXPECT_EQ(TextOf(*crossing).substr(0, 20), "ring 0 crosses ring ");
}

TEST(OutlineCrossingTest, OutlinesThatTouchDoNotCross) {
  const std::vector<Point2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_FALSE(FindCrossing({{square}}));
  EXPECT_FALSE(FindCrossing({{square, {{2, 2}, {4, 2}, {4, 4}}}})) << "a hole";
  EXPECT_FALSE(FindCrossing({{square, {{10, 10}, {20, 10}, {20, 20}}}})) << "a corner in common";
  EXPECT_FALSE(FindCrossing({{square, {{10, 2}, {20, 2}, {20, 4}, {10, 4}}}})) << "an edge in common";
  EXPECT_FALSE(FindCrossing({{{{0, 0}, {10, 0}, {5, 5}, {10, 10}, {0, 10}, {5, 5}}}})) << "touches itself";
  EXPECT_FALSE(FindCrossing({{{{0, 0}, {10, 0}, {15, 0}, {10, 0}, {10, 10}}}})) << "a spike";
  EXPECT_FALSE(FindCrossing({}));
}

TEST(OutlineCrossingTest, WhatATransformationLeavesIsNone) {
  const double off = 1e-4;  // of 5,000 km
  EXPECT_FALSE(FindCrossing({{{{0, 5e6}, {10, 5e6}, {10, 5e6 + 5}, {5, 5e6 - off}, {0, 5e6 + 5}}}}));
}

}  // namespace
}  // namespace tilemend
