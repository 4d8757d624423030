#include "coordinator/waves/pair_seams.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

// Two holes beside a seam of three new vertices, 0 to 2, between two original ones, 3 and 4.
class PairSeamsTest : public testing::Test {
 protected:
  PairSeamsTest() {
    plan_.vertices.resize(5);
    plan_.vertices[3].index = plan_.vertices[4].index = 7;
    plan_.holes.resize(2);
    plan_.holes[0].cell = {1, 1};
    plan_.holes[1].cell = {1, 2};
    const int32_t seam[] = {3, 0, 1, 2, 4};
    for (int k = 0; k < 4; ++k) {
      plan_.holes[0].segments.push_back({seam[k], seam[k + 1], true});
      plan_.holes[1].segments.push_back({seam[k + 1], seam[k], true});
    }
    for (PlannedHole& hole : plan_.holes) hole.layer = 1;
    for (const int32_t v : {0, 1, 2}) heights_.height[v] = 5;
  }
  std::map<CellPair, PairSeam> Find() const { return FindPairSeams(plan_, std::vector<int32_t>{0, 1}, heights_); }

  Plan plan_;
  SeamHeights heights_;
};

TEST_F(PairSeamsTest, FindsASeamBetweenHolesOfOneLayer) {
  const auto seams = Find();
  ASSERT_THAT(seams, SizeIs(1));
  EXPECT_THAT(seams.begin()->first, Pair(CellId{1, 1}, CellId{1, 2}));
  EXPECT_THAT(seams.begin()->second.holes_of_first, ElementsAre(0));
  EXPECT_THAT(seams.begin()->second.holes_of_second, ElementsAre(1));
  EXPECT_THAT(seams.begin()->second.vertices, ElementsAre(0, 1, 2));
}

TEST_F(PairSeamsTest, LeavesVerticesWithoutAHeight) {
  heights_.height.erase(1);
  EXPECT_THAT(Find().begin()->second.vertices, ElementsAre(0, 2));
}

// Over a corner of a ragged cut a seam may have cells on its sides that are no neighbours.
TEST_F(PairSeamsTest, NumbersThoseOfOneCellAcrossCornersToo) {
  plan_.vertices.resize(9);
  plan_.holes.resize(4);
  plan_.holes[2].cell = {2, 1};
  plan_.holes[3].cell = {2, 2};
  for (const int32_t h : {2, 3}) {
    const int32_t from = 2 * h + 1, to = from + 1;
    plan_.holes[0].segments.push_back({from, to, true});
    plan_.holes[h].segments.push_back({to, from, true});
    plan_.holes[h].layer = 1;
  }
  const auto seams = FindPairSeams(plan_, std::vector<int32_t>{0, 1, 2, 3}, heights_);
  std::vector<int32_t> numbers;
  for (const auto& [cells, seam] : seams) numbers.push_back(seam.number);
  EXPECT_THAT(numbers, ElementsAre(0, 1, 2));
}

TEST_F(PairSeamsTest, FindsNoneBetweenLayers) {
  plan_.holes[1].layer = 2;
  EXPECT_THAT(Find(), IsEmpty());
}

TEST_F(PairSeamsTest, FindsNoneInWater) {
  plan_.holes[0].water = plan_.holes[1].water = 0;
  EXPECT_THAT(Find(), IsEmpty());
}

TEST_F(PairSeamsTest, FindsNoneWhereAHoleIsLeft) {
  EXPECT_THAT(FindPairSeams(plan_, std::vector<int32_t>{0}, heights_), IsEmpty());
}

class PairSmoothingTest : public PairSeamsTest {
 protected:
  PairSmoothingTest() {
    scene_.plan = plan_;
    scene_.heights = heights_;
    scene_.holes_of = {{{1, 1}, {0}}, {{1, 2}, {1}}};
    options_.surface = Surface::kWang;
  }

  const SceneSurvey survey_{Scene(), {}};
  PlannedScene scene_{survey_};
  WaveOptions options_;
  PairSmoothing smoothing_;
};

TEST_F(PairSmoothingTest, BeginsWithTheSeamsBetweenFilledHoles) {
  EXPECT_THAT(smoothing_.Begin(scene_, {}, options_), ElementsAre(CellId{1, 1}));
}

TEST_F(PairSmoothingTest, LeavesSeamsOfAHoleThatFailed) {
  EXPECT_THAT(smoothing_.Begin(scene_, {{1, "no way"}}, options_), IsEmpty());
}

TEST_F(PairSmoothingTest, LeavesSeamsFarFromChosenCells) {
  options_.chosen = {{5, 5}};
  EXPECT_THAT(smoothing_.Begin(scene_, {}, options_), IsEmpty());
}

TEST_F(PairSmoothingTest, RefusesHeightsOfOtherVertices) {
  const std::array<CellId, 2> cells = {CellId{1, 1}, CellId{1, 2}};
  EXPECT_EQ(smoothing_.Take({cells, {0, 1}, {5}}, plan_).message(), "columns of unequal length");
  EXPECT_EQ(smoothing_.Take({cells, {9}, {5}}, plan_).message(), "vertex 9 is not in the plan");
  EXPECT_TRUE(smoothing_.Take({cells, {0, 1}, {5, 6}}, plan_).ok());
}

}  // namespace
}  // namespace tilemend
