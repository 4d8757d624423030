#include "coordinator/plan/doubtful_numbers.h"

#include <gtest/gtest.h>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

// Two cells of 6 m by 6 m, or `scale` times as large; in the eastern one a vertex lies at `lowest`.
PlanRemarks RemarksOn(double scale, double lowest) {
  SurveyedScene scene = PictureScene({"######|######", "###...|..####", "###...|..####",  //
                                      "######|######", "######|######", "######|######"},
                                     6);
  scene.grid.cell_size *= scale;
  scene.records.at({1, 0}).lo.z() = lowest;
  PlanRemarks remarks;
  RemarkOnNumbers(scene.Input(), remarks);
  return remarks;
}

TEST(RemarkOnNumbersTest, SaysNothingOfPlainTiles) {
  const PlanRemarks remarks = RemarksOn(1, -400);
  EXPECT_EQ(remarks.tiny_cell, 0);
  EXPECT_EQ(remarks.impossible_heights.tiles, 0);
}

TEST(RemarkOnNumbersTest, NamesTinyCells) { EXPECT_EQ(RemarksOn(0.1, 0).tiny_cell, 6 * 0.1); }

TEST(RemarkOnNumbersTest, NamesHeightsOfNoData) {
  const ImpossibleHeights heights = RemarksOn(1, -9999).impossible_heights;
  EXPECT_EQ(heights.tiles, 1);
  EXPECT_EQ(heights.first, (CellId{1, 0}));
  EXPECT_EQ(heights.lowest, -9999);
  EXPECT_EQ(heights.highest, 0);
}

}  // namespace
}  // namespace tilemend
