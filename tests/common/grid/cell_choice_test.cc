#include "common/grid/cell_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(ParseCellsTest, TakesCellsAndRanges) {
  EXPECT_THAT(*ParseCells("3,4  0,0-5,9 -3,-4--1,5"),
              ElementsAre(CellRange{{3, 4}, {3, 4}}, CellRange{{0, 0}, {5, 9}}, CellRange{{-3, -4}, {-1, 5}}));
  EXPECT_THAT(*ParseCells(""), IsEmpty());
}

TEST(ParseCellsTest, NamesWhatIsNeither) {
  for (const char* text :
       {"3", "3,", "3,4,5", "3,4-", "3,4-5", "a,b", "3,4;5,6", "0,0-5,9x", "99999999999,0", "3, 4"}) {
    const absl::Status status = ParseCells(std::string("1,1 ") + text).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(std::string(text).substr(0, 1)));
  }
  EXPECT_TRUE(absl::IsInvalidArgument(ParseCells(" ").status()));
  EXPECT_THAT(std::string(ParseCells("5,5-0,9").status().message()), HasSubstr("lowest"));
}

TEST(ChooseCellsTest, GivesThoseThatTheSceneHas) {
  Scene scene;
  for (const CellId cell : {CellId{0, 0}, CellId{1, 0}, CellId{0, 1}}) scene.tiles.push_back({cell, ""});
  EXPECT_THAT(*ChooseCells("0,0-9,0", scene), ElementsAre(CellId{0, 0}, CellId{1, 0}));
  EXPECT_THAT(*ChooseCells("0,0 0,0", scene), ElementsAre(CellId{0, 0}));
  EXPECT_THAT(*ChooseCells("", scene), IsEmpty());
  EXPECT_EQ(ChooseCells("0,0 7,7", scene).status().message(), "cell +007_+007: the scene does not have it");
  EXPECT_EQ(ChooseCells("7,7-8,8", scene).status().message(),
            "cells +007_+007 to +008_+008: the scene has none of them");
}

}  // namespace
}  // namespace tilemend
