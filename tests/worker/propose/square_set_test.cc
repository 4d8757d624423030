#include "worker/propose/square_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

// A frame of 5 x 5 squares around 9 others, away from the origin.
std::vector<Square> Frame() {
  std::vector<Square> squares;
  for (int32_t row = -2; row < 3; ++row) {
    for (int32_t col = 7; col < 12; ++col) {
      if (row == -2 || row == 2 || col == 7 || col == 11) squares.push_back({col, row});
    }
  }
  return squares;
}

TEST(SquareSetTest, HasItsSquaresAndNoOthers) {
  const SquareSet set = SetOf(Frame());
  EXPECT_EQ(CountOf(set), 16);
  EXPECT_TRUE(set.Has(7, -2));
  EXPECT_FALSE(set.Has(8, -1));
  EXPECT_FALSE(set.Has(12, 0));
  EXPECT_FALSE(set.Has(-100, 100));
  EXPECT_EQ(CountOf(SetOf({})), 0);
}

TEST(SquareSetTest, SmallIslandsAreFilled) {
  const SquareSet set = SetOf(Frame());
  EXPECT_EQ(CountOf(WithSmallIslands(set, 8)), 16);
  EXPECT_EQ(CountOf(WithSmallIslands(set, 9)), 25);
  std::vector<Square> open = Frame();
  open.pop_back();  // a corner: what is inside touches the outside at a corner alone
  EXPECT_EQ(CountOf(WithSmallIslands(SetOf(open), 9)), 24);
  std::erase(open, Square{9, 2});
  EXPECT_EQ(CountOf(WithSmallIslands(SetOf(open), 9)), 14) << "no island";
}

TEST(SquareSetTest, TheRimIsAllAround) {
  EXPECT_THAT(RimOf(SetOf({{3, 4}})), SizeIs(8));
  EXPECT_EQ(RimOf(SetOf({{3, 4}})).front(), (Square{2, 3}));
  EXPECT_THAT(RimOf(SetOf(Frame())), SizeIs(24 + 8));
}

}  // namespace
}  // namespace tilemend
