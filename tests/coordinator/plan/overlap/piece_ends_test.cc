#include "coordinator/plan/overlap/piece_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/piece_rings.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

constexpr double kReach = 0.4;

PieceMatches Match(const PieceRings& tile, const std::vector<PieceEnd>& ends) {
  return MatchPieceEnds(tile.Boundary(), ends, kReach);
}

// Of the north-eastern piece a few triangles are left; the corner of the south-eastern one is missing, and what bounds
// it lies nearer to itself than to where it goes on.
TEST(MatchPieceEndsTest, FollowsTheOutlinesAndNotWhatIsNearest) {
  PieceRings tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, 5.2}, {3, 5.2}, {0, 4}}, "oppco");
  tile.Add({{9.8, 0}, {20, 0}, {20, 5.2}, {13, 5.2}, {9.8, 3}}, "oopcp");
  tile.Add({{18, 4.8}, {20, 4.8}, {20, 7}}, "poc");
  const std::vector<PieceEnd> ends = {
      {tile.At(3, 5.2), true}, {tile.At(13, 5.2), true}, {tile.At(9.8, 3), false}, {tile.At(18, 4.8), false}};
  const PieceMatches matches = Match(tile, ends);
  EXPECT_THAT(matches.pairs, UnorderedElementsAre(Pair(0, 2), Pair(1, 3)));
  EXPECT_THAT(matches.on_outline, IsEmpty());
}

TEST(MatchPieceEndsTest, SaysWhereTheWayComesToTheOutline) {
  const PieceRings tile = RiversEnd();
  const PieceMatches matches = Match(tile, {{tile.At(9.8, 8), true}});
  EXPECT_THAT(matches.pairs, IsEmpty());
  EXPECT_THAT(matches.on_outline, ElementsAre(Pair(0, tile.At(20, 5.2))));
}

TEST(MatchPieceEndsTest, AnEndNearByThatHasLostItsWayGoesBeforeTheOutline) {
  PieceRings tile = RiversEnd();
  tile.Add({{11, 7.5}, {12, 7.5}, {12, 7.9}}, "ccc");
  const PieceMatches matches = Match(tile, {{tile.At(9.8, 8), true}, {tile.At(11, 7.5), false}});
  EXPECT_THAT(matches.pairs, ElementsAre(Pair(0, 1)));
  EXPECT_THAT(matches.on_outline, IsEmpty());
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
  EXPECT_THAT(matches.on_outline, UnorderedElementsAre(Pair(2, 6), Pair(3, 9)));
}

}  // namespace
}  // namespace tilemend
