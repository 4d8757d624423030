#include "coordinator/plan/water/area_cover.h"

#include <gtest/gtest.h>

#include <optional>
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

TEST(CoverLinesTest, AreasThatOverlapCountOnce) {
  const CoverLines hole(Segments({Box(0, 0, 4, 2)}));
  const WaterArea west{true, {{Box(-1, -1, 2, 3)}}}, middle{true, {{Box(1, -1, 3, 3)}}};
  EXPECT_NEAR(hole.ShareIn(std::vector{&west, &middle}), 0.75, 1e-12);
  EXPECT_NEAR(hole.ShareIn(std::vector{&west, &west}), 0.5, 1e-12);
}

// Areas that cover shares of a hole of 10 m, from its west end on.
class DecidingAreaTest : public ::testing::Test {
 protected:
  std::optional<DecidingArea> Find() const {
    std::vector<double> shares;
    for (const WaterArea& area : areas_) shares.push_back(hole_.ShareIn(area));
    return FindDecidingArea(hole_, shares, areas_);
  }
  void Add(double x0, double x1) { areas_.push_back({true, {{Box(x0, 0, x1, 2)}}}); }

  const CoverLines hole_{Segments({Box(0, 0, 10, 2)})};
  std::vector<WaterArea> areas_;
};

TEST_F(DecidingAreaTest, TheLastThatCoversMostDecides) {
  Add(0, 9), Add(0, 6), Add(0, 5);
  EXPECT_EQ(Find()->area, 1u);
  EXPECT_FALSE(Find()->together);
}

TEST_F(DecidingAreaTest, AreasThatSayTheSameDecideTogether) {
  Add(0, 3), Add(3, 6.5), Add(6.5, 9.5);
  for (WaterArea& area : areas_) area.clear = true;
  areas_[0].level = 3.0, areas_[1].level = 3.2, areas_[2].level = 3.1;
  EXPECT_FALSE(Find()) << "given levels that differ";
  for (WaterArea& area : areas_) area.level_sigma = 0.25;
  ASSERT_TRUE(Find());
  EXPECT_EQ(Find()->area, 1u);
  EXPECT_TRUE(Find()->together);
  EXPECT_NEAR(Find()->share, 0.95, 1e-12);
  areas_[1].water = false;
  EXPECT_TRUE(Find()) << "the other two";
  areas_[2].kind = WaterKind::kRiver;
  EXPECT_FALSE(Find());
}

TEST_F(DecidingAreaTest, TheSameAreaTwiceCoversNoMore) {
  Add(0, 3), Add(0, 3);
  EXPECT_FALSE(Find());
}

TEST(CoverLinesTest, WhatHasNoAreaIsNotCovered) {
  const std::vector<PlaneSegment> line = {{{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}};
  EXPECT_EQ(CoverLines(line).ShareIn({true, {{Box(-1, -1, 2, 2)}}}), 0);
}

}  // namespace
}  // namespace tilemend
