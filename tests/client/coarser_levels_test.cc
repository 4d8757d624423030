#include "client/coarser_levels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::vector<LevelCounts> kReported = {{2, 2, 10, 0}, {4, 3, 30, 5}};

TileChange Change(int64_t added, size_t missing = 0) { return {std::vector<int32_t>(missing, 0), {}, added}; }

TEST(CoarserLevelsTest, LevelsAsReportedAreRight) {
  CoarserLevels levels(kReported);
  levels.Add({0, 0}, {Change(10), Change(20)}, false);
  levels.Add({1, 0}, {Change(0), Change(10)}, false);  // its coarsest level had no hole
  EXPECT_THAT(levels.Unfilled(), IsEmpty());
  EXPECT_THAT(levels.Cleared(), IsEmpty());
}

TEST(CoarserLevelsTest, ALevelThatLacksItsFillIsNamed) {
  CoarserLevels levels(kReported);
  levels.Add({0, 0}, {Change(4), Change(20)}, false);
  levels.Add({1, 0}, {Change(0), Change(10)}, false);
  levels.Add({2, 0}, {Change(0), Change(0)}, false);
  ASSERT_THAT(levels.Unfilled(), SizeIs(1));
  EXPECT_EQ(levels.Unfilled()[0].cell, (CellId{1, 0}));
  EXPECT_THAT(levels.Unfilled()[0].note, HasSubstr("level of detail 0"));
}

TEST(CoarserLevelsTest, AFillMayPutClearedTrianglesThereAgain) {
  CoarserLevels levels({{1, 1, 10, 4}, {1, 1, 10, 0}});
  levels.Add({0, 0}, {Change(6), Change(10)}, true);
  levels.Add({1, 0}, {Change(0), Change(10)}, true);
  EXPECT_THAT(levels.Unfilled(), IsEmpty());
}

TEST(CoarserLevelsTest, NoLevelLacksMoreThanWasCleared) {
  CoarserLevels levels({{1, 1, 10, 4}, {1, 1, 30, 5}});
  levels.Add({0, 0}, {Change(10, 4), Change(30, 9)}, true);  // the finest shows what it has of the coarsest
  levels.Add({1, 0}, {Change(0, 7), Change(0)}, false);
  EXPECT_THAT(levels.Cleared(), IsEmpty());
  levels.Add({2, 0}, {Change(0, 1), Change(0)}, true);
  ASSERT_THAT(levels.Cleared(), SizeIs(1));
  EXPECT_THAT(levels.Cleared()[0].note, HasSubstr("5 taken out, 4 reported"));
}

TEST(CoarserLevelsTest, AReportWithoutLevelsSaysNothing) {
  CoarserLevels levels({});
  levels.Add({0, 0}, {Change(0, 7), Change(10)}, true);
  EXPECT_THAT(levels.Unfilled(), IsEmpty());
  EXPECT_THAT(levels.Cleared(), IsEmpty());
}

}  // namespace
}  // namespace tilemend
