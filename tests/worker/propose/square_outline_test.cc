#include "worker/propose/square_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

double SignedArea(const std::vector<Point2>& ring) {
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    area += (a.x() * b.y() - b.x() * a.y()) / 2;
  }
  return area;
}

std::vector<Square> Block(int32_t col, int32_t row, int32_t cols, int32_t rows) {
  std::vector<Square> squares;
  for (int32_t r = row; r < row + rows; ++r) {
    for (int32_t c = col; c < col + cols; ++c) squares.push_back({c, r});
  }
  return squares;
}

TEST(OutlineOfTest, ABlockHasItsCornersCut) {
  const PlanePolygon outline = OutlineOf(SetOf(Block(-3, 2, 10, 4)), 0.5);
  ASSERT_THAT(outline.rings, SizeIs(1));
  EXPECT_THAT(outline.rings[0], SizeIs(8));
  EXPECT_DOUBLE_EQ(SignedArea(outline.rings[0]), 0.25 * (40 - 4 * 0.125));
  EXPECT_TRUE(Contains(outline, {-1.4, 1.3}));
  EXPECT_FALSE(Contains(outline, {-1.6, 1.3}));
}

TEST(OutlineOfTest, IslandsTurnTheOtherWay) {
  std::vector<Square> squares = Block(0, 0, 9, 9);
  std::erase(squares, Square{4, 4});
  const PlanePolygon outline = OutlineOf(SetOf(squares), 1);
  ASSERT_THAT(outline.rings, SizeIs(2));
  EXPECT_GT(SignedArea(outline.rings[0]), 0);
  EXPECT_LT(SignedArea(outline.rings[1]), 0);
  EXPECT_FALSE(Contains(outline, {4.5, 4.5}));
}

TEST(OutlineOfTest, SquaresThatTouchAtACornerAreApart) {
  const PlanePolygon outline = OutlineOf(SetOf({{0, 0}, {1, 1}}), 1);
  ASSERT_THAT(outline.rings, SizeIs(2));
  for (const auto& ring : outline.rings) EXPECT_DOUBLE_EQ(SignedArea(ring), 0.5);
}

TEST(OutlineOfTest, NothingHasNone) { EXPECT_THAT(OutlineOf(SetOf({}), 1).rings, IsEmpty()); }

}  // namespace
}  // namespace tilemend
