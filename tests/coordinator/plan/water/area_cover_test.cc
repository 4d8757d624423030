#include "coordinator/plan/water/area_cover.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

std::vector<Point2> Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

std::vector<PlaneSegment> Segments(const std::vector<std::vector<Point2>>& rings) {
  std::vector<PlaneSegment> segments;
  for (const auto& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  return segments;
}

TEST(CoverLinesTest, IsTheShareOfTheHole) {
  const auto hole = Segments({Box(0, 0, 4, 2)});
  EXPECT_NEAR(CoverLines(hole).ShareIn({true, {{Box(-1, -1, 5, 3)}}}), 1, 1e-12);
  EXPECT_NEAR(CoverLines(hole).ShareIn({true, {{Box(3, -1, 9, 3)}}}), 0.25, 1e-12);
  EXPECT_NEAR(CoverLines(hole).ShareIn({true, {{Box(-1, 1.5, 9, 3)}}}), 0.25, 1e-12);
  EXPECT_NEAR(CoverLines(hole).ShareIn({true, {{Box(0, 0, 1, 2), Box(2, 0, 4, 2)}}}), 0.75, 1e-12);
  EXPECT_EQ(CoverLines(hole).ShareIn({true, {{Box(10, 0, 11, 2)}}}), 0);
  EXPECT_EQ(CoverLines(hole).ShareIn({true, {}}), 0);
}

TEST(CoverLinesTest, IslandsAreNotPartOfTheHole) {
  const auto hole = Segments({Box(0, 0, 4, 4), Box(1, 0, 3, 4)});
  EXPECT_NEAR(CoverLines(hole).ShareIn({true, {{Box(0, 0, 2, 4)}}}), 0.5, 1e-12);
}

TEST(CoverLinesTest, ARingInAnAreaIsAnOpening) {
  EXPECT_NEAR(CoverLines(Segments({Box(0, 0, 4, 4)})).ShareIn({true, {{Box(-1, -1, 5, 5), Box(0, 0, 4, 2)}}}), 0.5,
              1e-12);
}

TEST(CoverLinesTest, ASeamBoundsNothing) {
  auto parts = Segments({Box(0, 0, 2, 2), Box(2, 0, 4, 2)});
  EXPECT_NEAR(CoverLines(parts).ShareIn({true, {{Box(0, 0, 3, 2)}}}), 0.75, 1e-12);
}

TEST(CoverLinesTest, WhatHasNoAreaIsNotCovered) {
  const std::vector<PlaneSegment> line = {{{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}};
  EXPECT_EQ(CoverLines(line).ShareIn({true, {{Box(-1, -1, 2, 2)}}}), 0);
}

}  // namespace
}  // namespace tilemend
