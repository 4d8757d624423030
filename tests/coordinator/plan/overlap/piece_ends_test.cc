#include "coordinator/plan/overlap/piece_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/piece_rings.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::Eq;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

constexpr double kReach = 0.4;

// Where two chains cross.
ChainPassage Crossing(int32_t arriving, int32_t leaving, const Point2& place) {
  return {ChainPlace{arriving, place}, ChainPlace{leaving, place}, {}};
}

// The shores of two pieces that overlap from x = 9.8 to 10.2: of the western one from (10.2, 4) on, of the eastern one
// to (9.8, 4.1). Another shore of a third piece ends nearer to where each of them does.
struct CrossingShores {
  PieceRings tile;
  int32_t western = 2, eastern = 7;  // edges

  CrossingShores() {
    tile.Add({{0, 0}, {10.2, 0}, {10.2, 4}, {8, 4.4}, {0, 4}}, "opcco");
    tile.Add({{9.8, 0}, {20, 0}, {20, 3}, {9.8, 4.1}}, "oocp");
    tile.Add({{10.25, 4}, {9.75, 4.1}, {9, 6}}, "pcc");
  }

  PieceMatches Match(const std::vector<ChainPassage>& passages) const {
    PieceBoundary boundary = tile.Boundary();
    boundary.passages = passages;
    return MatchPieceEnds(
        boundary,
        {{tile.At(10.2, 4), true}, {tile.At(9.8, 4.1), false}, {tile.At(9.75, 4.1), true}, {tile.At(10.25, 4), false}},
        kReach);
  }
};

TEST(MatchPieceEndsTest, TakesTheNearestWithoutACrossing) {
  EXPECT_THAT(CrossingShores().Match({}).pairs, UnorderedElementsAre(Pair(0, 3), Pair(2, 1)));
}

TEST(MatchPieceEndsTest, TakesChainsThatCross) {
  const CrossingShores shores;
  const PieceMatches matches = shores.Match({Crossing(shores.eastern, shores.western, {10, 4.04})});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 1), Pair(2, 3)));
  EXPECT_THAT(matches.on_outline, IsEmpty());
}

TEST(MatchPieceEndsTest, OfSeveralCrossingsTakesTheNearestToTheEnd) {
  const CrossingShores shores;
  const int32_t third = 10;
  const PieceMatches matches = shores.Match(
      {Crossing(shores.eastern, third, {10.1, 4.06}), Crossing(shores.eastern, shores.western, {9.95, 4.05})});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 1), Pair(2, 3)));
}

TEST(MatchPieceEndsTest, ACrossingFartherFromAnEndThanPiecesOverlapSaysNothing) {
  const CrossingShores shores;
  const PieceMatches matches = shores.Match({Crossing(shores.eastern, shores.western, {9, 4.2})});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 3), Pair(2, 1)));
}

// One chain comes to the other along the outline of a piece, 9 m away.
TEST(MatchPieceEndsTest, ChainsMayBeFarFromEachOther) {
  const CrossingShores shores;
  const PieceMatches matches =
      shores.Match({{ChainPlace{shores.eastern, {9.9, 4.08}}, ChainPlace{shores.western, {10.1, 4.02}}, {}}});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 1), Pair(2, 3)));
}

TEST(MatchPieceEndsTest, ACrossingOfChainsAboveEachOtherSaysNothing) {
  CrossingShores shores;
  for (const auto& [x, y] : {std::pair(9.8, 4.1), std::pair(9.75, 4.1)}) {
    shores.tile.record.vertices[shores.tile.At(x, y)].position.z() = x == 9.8 ? 6 : 0;
  }
  shores.tile.record.vertices[shores.tile.At(10.25, 4)].position.z() = 6;
  shores.tile.record.vertices[shores.tile.At(10.2, 4)].position.z() = 0;
  const PieceMatches matches = shores.Match({Crossing(shores.eastern, shores.western, {10, 4.04})});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 3), Pair(2, 1)));
}

TEST(MatchPieceEndsTest, SaysWhereTheWayComesToTheOutline) {
  const CrossingShores shores;
  const Point2 there(0, 7);
  PieceBoundary boundary = shores.tile.Boundary();
  boundary.passages = {{{}, ChainPlace{shores.western, {10.1, 4.02}}, there}};
  const PieceMatches matches = MatchPieceEnds(boundary, {{shores.tile.At(10.2, 4), true}}, kReach);
  EXPECT_THAT(matches.pairs, IsEmpty());
  EXPECT_THAT(matches.on_outline, ElementsAre(Pair(0, Eq(there))));
}

// Two ends whose ways lead to the outline do not go together, near as they are.
TEST(MatchPieceEndsTest, WaysToTheOutlineAreNotJoined) {
  const CrossingShores shores;
  PieceBoundary boundary = shores.tile.Boundary();
  boundary.passages = {{{}, ChainPlace{shores.western, {10.1, 4.02}}, Point2(0, 7)},
                       {ChainPlace{shores.eastern, {9.9, 4.08}}, {}, Point2(20, 7)}};
  const PieceMatches matches =
      MatchPieceEnds(boundary, {{shores.tile.At(10.2, 4), true}, {shores.tile.At(9.8, 4.1), false}}, kReach);
  EXPECT_THAT(matches.pairs, IsEmpty());
  EXPECT_THAT(matches.on_outline, UnorderedElementsAre(Pair(0, Eq(Point2(0, 7))), Pair(1, Eq(Point2(20, 7)))));
}

PieceMatches Match(const PieceRings& tile, const std::vector<PieceEnd>& ends) {
  return MatchPieceEnds(tile.Boundary(), ends, kReach);
}

// Ends that no outline leads on from.
PieceRings LooseEnds(const std::vector<Point2>& ends) {
  PieceRings tile;
  for (const Point2& p : ends) tile.Add({p, p + Point2(1, 0), p + Point2(1, 1)}, "ccc");
  return tile;
}

TEST(MatchPieceEndsTest, TakesTheNearestWhereTheWayIsLost) {
  const PieceRings tile = LooseEnds({{0, 0}, {5, 0}, {6.5, 0}, {30, 0}});
  const PieceMatches matches = Match(tile, {{0, true}, {3, true}, {6, false}, {9, false}});
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(1, 2), Pair(0, 3)));
  EXPECT_THAT(matches.on_outline, IsEmpty());
}

TEST(MatchPieceEndsTest, OnTheOutlineOnlyWhatIsNearBelongsTogether) {
  const PieceRings tile = LooseEnds({{0, 0}, {3, 0}, {10, 0}, {20, 0}});
  PieceBoundary boundary = tile.Boundary();
  for (const int32_t v : {0, 3, 6}) boundary.on_outline[v] = true;
  const PieceMatches matches = MatchPieceEnds(boundary, {{0, true}, {3, false}, {6, true}, {9, false}}, kReach);
  EXPECT_THAT(matches.pairs, ElementsAre(Pair(0, 1)));
  EXPECT_THAT(matches.on_outline, ElementsAre(Pair(2, Eq(std::nullopt)), Pair(3, Eq(std::nullopt))));
}

}  // namespace
}  // namespace tilemend
