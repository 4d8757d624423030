#include "coordinator/plan/overlap/piece_walk.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/support/piece_rings.h"

namespace tilemend {
namespace {

constexpr double kReach = 4;

// The tile is 20 m by 10 m; two pieces, or columns of pieces, overlap from x = 9.8 to 10.2.
struct Walker : PieceRings {
  std::optional<PieceWalk::Arrival> From(int32_t end, bool backward = false) const {
    const PieceBoundary boundary = Boundary();
    return PieceWalk(boundary, kReach).From(end, backward);
  }

  // Both ways.
  void ExpectNext(int32_t end, int32_t begin) const {
    const auto next = From(end), before = From(begin, true);
    ASSERT_TRUE(next && before);
    EXPECT_EQ(next->vertex, begin);
    EXPECT_EQ(before->vertex, end);
    EXPECT_FALSE(next->on_outline || before->on_outline);
  }

  void ExpectOutline(int32_t end, bool backward, int32_t there) const {
    const auto arrival = From(end, backward);
    ASSERT_TRUE(arrival);
    EXPECT_EQ(arrival->vertex, there);
    EXPECT_TRUE(arrival->on_outline);
  }
};

// The shore of the western piece from (10.2, y) on, by way of (9, far), and that of the eastern one to (9.8, y_east).
Walker Shores(double y, double far, double y_east) {
  Walker tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, y}, {9, far}, {0, far}}, "opcco");
  tile.Add({{9.8, 0}, {20, 0}, {20, y_east}, {9.8, y_east}}, "oocp");
  return tile;
}

TEST(PieceWalkTest, AChainEndsUnderAPieceAndItsOutlineLeadsToTheNext) { Shores(4, 4, 3).ExpectNext(8, 2); }

TEST(PieceWalkTest, AChainEndsInTheOpenAndItsOwnOutlineLeadsToTheNext) {
  const Walker tile = Shores(3, 3, 4);
  tile.ExpectNext(tile.At(9.8, 4), tile.At(10.2, 3));
}

TEST(PieceWalkTest, ChainsMayCrossBeforeEitherMeetsAnOutline) {
  const Walker tile = Shores(3, 6, 3.5);
  tile.ExpectNext(tile.At(9.8, 3.5), tile.At(10.2, 3));
}

TEST(PieceWalkTest, TheWayMayLeadToTheOutlineAroundAnotherPiece) {
  const Walker tile{RiversEnd()};
  tile.ExpectOutline(tile.At(9.8, 8), true, tile.At(20, 5.2));
}

// The outlines of three pieces run along one line there, and a chain ends at the corner of its piece.
TEST(PieceWalkTest, CornersOfFourPiecesAreNoObstacle) {
  Walker tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, 5.2}, {0, 5.2}}, "oppo");
  tile.Add({{0, 4.8}, {10.2, 4.8}, {10.2, 10}, {0, 10}}, "ppoo");
  tile.Add({{9.8, 4.8}, {15, 4.8}, {17, 10}, {9.8, 10}}, "pcop");
  tile.Add({{9.8, 5.2}, {9.8, 1}, {12, 4}}, "pcc");  // ends at its north-western corner
  tile.ExpectNext(tile.At(9.8, 5.2), tile.At(15, 4.8));
}

TEST(PieceWalkTest, AChainThatComesOutFromUnderAPieceAgainIsNotLeftThere) {
  Walker tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, 4}, {0, 4}}, "opco");
  tile.Add({{9.8, 0}, {20, 0}, {20, 3}, {10, 3}, {10, 6}, {9.8, 6}}, "oocccp");
  // The last edges lie north of the western piece's shore: its own outline leads back to that.
  tile.ExpectNext(tile.At(9.8, 6), tile.At(10.2, 4));
}

TEST(PieceWalkTest, AnEndOnTheOutlineIsThere) {
  Walker tile;
  tile.Add({{0, 0}, {20, 0}, {20, 4}, {0, 4}}, "ooco");
  tile.ExpectOutline(tile.At(0, 4), false, tile.At(0, 4));
}

TEST(PieceWalkTest, AWayThatNothingLeadsOnFromIsLost) {
  Walker tile;
  tile.Add({{2, 2}, {4, 2}, {4, 4}}, "ccc");
  EXPECT_FALSE(tile.From(0).has_value());
  Walker ring;  // the outline of a whole piece leads back to itself
  ring.Add({{2, 2}, {8, 2}, {8, 8}, {2, 8}}, "pppp");
  ring.Add({{6, 3}, {20, 3}, {20, 5}, {6, 5}}, "oocp");
  EXPECT_FALSE(ring.From(ring.At(6, 5)).has_value());
}

}  // namespace
}  // namespace tilemend
