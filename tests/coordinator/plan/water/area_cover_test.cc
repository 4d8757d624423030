#include "coordinator/plan/water/area_cover.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
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

std::vector<AreaShare> SharesOf(const CoverLines& region, const std::vector<WaterArea>& areas) {
  std::vector<AreaShare> shares;
  for (size_t a = 0; a < areas.size(); ++a) {
    if (const double share = region.ShareIn(areas[a]); share > 0) shares.push_back({a, share});
  }
  return shares;
}

// What FindDecidingArea is to find, area by area.
std::optional<DecidingArea> FindOneByOne(const CoverLines& region, const std::vector<WaterArea>& areas) {
  const std::vector<AreaShare> shares = SharesOf(region, areas);
  for (size_t i = shares.size(); i-- > 0;) {
    if (shares[i].share > kDecidingShare) return DecidingArea{shares[i].area, shares[i].share, false};
  }
  std::optional<DecidingArea> most;
  double share_of_most = 0;
  for (const AreaShare& a : shares) {
    if (a.share <= share_of_most) continue;
    std::vector<const WaterArea*> same;
    double sum = 0;
    for (const AreaShare& b : shares) {
      if (!SayTheSame(areas[a.area], areas[b.area])) continue;
      same.push_back(&areas[b.area]);
      sum += b.share;
    }
    const double share = region.ShareIn(same);
    if (sum <= kDecidingShare || share <= kDecidingShare) continue;
    most = DecidingArea{a.area, share, true};
    share_of_most = a.share;
  }
  return most;
}

// Areas that cover shares of a hole of 10 m, from its west end on.
class DecidingAreaTest : public ::testing::Test {
 protected:
  std::optional<DecidingArea> Find() const {
    return FindDecidingArea(hole_, SharesOf(hole_, areas_), areas_, [&] {
      ++asked_;
      return is_cancelled_;
    });
  }
  void Add(double x0, double x1) { areas_.push_back({true, {{Box(x0, 0, x1, 2)}}}); }

  const CoverLines hole_{Segments({Box(0, 0, 10, 2)})};
  std::vector<WaterArea> areas_;
  mutable int asked_ = 0;  // at each line of each union of areas
  bool is_cancelled_ = false;
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

TEST_F(DecidingAreaTest, AnAreaWithACentrelineSaysWhatNoOtherDoes) {
  Add(0, 3), Add(3, 6);
  areas_[0].centreline = {{0, 1}, {3, 1}};
  EXPECT_FALSE(SayTheSame(areas_[0], areas_[0]));
  EXPECT_FALSE(Find());
}

// Levels within a centimetre are the same: the first is that of the second, and that of the third, but not the first.
TEST_F(DecidingAreaTest, LevelsThatRunOnAreNotAllTheSame) {
  Add(0, 2), Add(2, 4.5), Add(4.5, 6.5);
  areas_[0].level = 3.0, areas_[1].level = 3.008, areas_[2].level = 3.016;
  ASSERT_TRUE(Find());
  EXPECT_EQ(Find()->area, 1u);
  EXPECT_NEAR(Find()->share, 0.65, 1e-12);
  areas_[1].water = false;
  EXPECT_FALSE(Find());
}

TEST_F(DecidingAreaTest, IsAsFoundOneByOne) {
  std::mt19937 random(7);
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    areas_.clear();
    for (int i = 0; i < 30; ++i) {
      const double x = below(90) / 10;
      Add(x, x + below(36) / 20);
      WaterArea& area = areas_.back();
      area.water = below(8) > 0;
      area.clear = below(4) > 0;
      if (below(5) > 0) area.level = below(30) / 500;
      if (below(6) == 0) area.level_sigma = below(30) / 1000;
    }
    const auto expected = FindOneByOne(hole_, areas_), decides = Find();
    ASSERT_EQ(decides.has_value(), expected.has_value()) << round;
    if (!decides) continue;
    ++found;
    EXPECT_EQ(decides->area, expected->area) << round;
    EXPECT_EQ(decides->share, expected->share) << round;
    EXPECT_EQ(decides->together, expected->together) << round;
  }
  EXPECT_GT(found, 30);
  EXPECT_LT(found, 270);
}

TEST_F(DecidingAreaTest, EqualAreasAreMeasuredOnce) {
  for (int i = 0; i < 1000; ++i) Add(0, 3);
  EXPECT_FALSE(Find());
  EXPECT_LT(asked_, 200);
  asked_ = 0;
  for (int i = 0; i < 1000; ++i) areas_[i].level = i * 0.001;
  EXPECT_FALSE(Find());
  EXPECT_LT(asked_, 200);
}

TEST_F(DecidingAreaTest, LevelsThatRunOnAreMeasuredFewTimes) {
  for (int i = 0; i < 1000; ++i) {
    Add(i * 0.01, (i + 1) * 0.01);
    areas_.back().level = i * 0.001;
  }
  EXPECT_FALSE(Find()) << "each with 20 others";
  EXPECT_LT(asked_, 2000);
  asked_ = 0;
  for (WaterArea& area : areas_) area.level_sigma = 0.7;
  EXPECT_TRUE(Find());
  EXPECT_LT(asked_, 4000);
}

TEST_F(DecidingAreaTest, NoneDecidesOnceItIsCancelled) {
  Add(0, 3), Add(3, 6);
  EXPECT_TRUE(Find());
  is_cancelled_ = true;
  asked_ = 0;
  EXPECT_FALSE(Find());
  EXPECT_EQ(asked_, 1);
}

TEST(CoverLinesTest, ItIsAskedAtEachLineWhetherItIsCancelled) {
  const CoverLines hole(Segments({Box(0, 0, 4, 2)}));
  const WaterArea west{true, {{Box(-1, -1, 2, 3)}}};
  int asked = 0;
  EXPECT_EQ(hole.ShareIn(std::vector{&west}, [&] { return ++asked == 5; }), 0);
  EXPECT_EQ(asked, 5);
}

TEST(CoverLinesTest, WhatHasNoAreaIsNotCovered) {
  const std::vector<PlaneSegment> line = {{{0, 0}, {1, 1}}, {{1, 1}, {0, 0}}};
  EXPECT_EQ(CoverLines(line).ShareIn({true, {{Box(-1, -1, 2, 2)}}}), 0);
}

}  // namespace
}  // namespace tilemend
