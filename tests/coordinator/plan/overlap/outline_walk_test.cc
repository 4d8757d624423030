#include "coordinator/plan/overlap/outline_walk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/overlapping_scene.h"
#include "tests/support/piece_rings.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr Outline kSquare{{0, 6, 0, 6}};

SurveyRecord RecordOf(const std::vector<std::string>& picture) {
  return PictureScene(picture, 6).records.begin()->second;
}

OutlineWalk Walk(const SurveyRecord& record) {
  return WalkOutline(record, std::vector<bool>(record.edges.size(), true), kSquare, 0.3);
}

TEST(OutlineTest, NumbersPlacesCounterClockwiseFromTheSouthWest) {
  EXPECT_EQ(kSquare.PlaceOf({2, 0, 0}, kSouth), 2);
  EXPECT_EQ(kSquare.PlaceOf({6, 2, 0}, kEast), 8);
  EXPECT_EQ(kSquare.PlaceOf({2, 6, 0}, kNorth), 16);
  EXPECT_EQ(kSquare.PlaceOf({0, 2, 0}, kWest), 22);
  EXPECT_EQ(kSquare.PlaceOf({0, 0, 0}, kWest), 0);
  EXPECT_EQ(kSquare.CornerPlace(2), 12);
  EXPECT_EQ(kSquare.CornerAt(2), Point2(6, 6));
}

TEST(OutlineWalkTest, HasNoGapAroundAWholeTile) {
  const SurveyRecord record = RecordOf({"######", "######", "######", "######", "######", "######"});
  const OutlineWalk walk = Walk(record);
  EXPECT_THAT(walk.gaps, IsEmpty());
  EXPECT_FALSE(walk.all_open);
  EXPECT_EQ(walk.on_outline, std::vector<bool>(record.edges.size(), true));
}

TEST(OutlineWalkTest, FindsTheGapsOfARiver) {
  const SurveyRecord record = RecordOf({"######", "######", "......", "......", "######", "######"});
  const OutlineWalk walk = Walk(record);
  ASSERT_THAT(walk.gaps, SizeIs(2));
  for (const OutlineGap& gap : walk.gaps) {
    EXPECT_TRUE(gap.open);
    EXPECT_EQ(gap.end - gap.begin, 2);
    EXPECT_EQ(record.vertices[gap.from].position.x(), record.vertices[gap.to].position.x());
  }
}

TEST(OutlineWalkTest, GoesAroundCorners) {
  const SurveyRecord record = RecordOf({"######", "######", "######", "######", "..####", "..####"});
  const OutlineWalk walk = Walk(record);
  ASSERT_THAT(walk.gaps, SizeIs(1));
  EXPECT_EQ(walk.gaps[0].begin, 22);
  EXPECT_EQ(walk.gaps[0].end, 24 + 2) << "by way of the south-west corner";
}

TEST(OutlineWalkTest, SaysThatNothingReachesTheOutline) {
  EXPECT_TRUE(Walk(RecordOf({"......", ".####.", ".####.", ".####.", ".####.", "......"})).all_open);
}

// A tile may begin a hair beside its corner: nobody's surface is missing there.
TEST(OutlineWalkTest, AHairWithoutSurfaceIsNoMissingTile) {
  SurveyRecord record;
  const Point3 corners[] = {{1e-9, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 1e-9, 0}};
  for (const Point3& p : corners) record.vertices.push_back({-1, p});
  for (int32_t k = 0; k < 4; ++k) record.edges.push_back({k, k + 1, 0});
  const OutlineWalk walk = Walk(record);
  EXPECT_FALSE(walk.all_open);
}

// A wall that stands on the northern outline, over ground that goes on below.
SurveyRecord WithSheetAbove(SurveyRecord record, double west, double east) {
  const auto base = static_cast<int32_t>(record.vertices.size());
  const Point3 corners[] = {{west, 6, 5}, {west, 5, 5}, {east, 5, 5}, {east, 6, 5}};
  for (const Point3& p : corners) record.vertices.push_back({-1, p});
  for (int32_t k = 0; k < 4; ++k) record.edges.push_back({base + k, base + (k + 1) % 4, 1});
  return record;
}

TEST(OutlineWalkTest, ClosesASheetAboveOthersForItself) {
  const SurveyRecord plain = RecordOf({"######", "##..##", "##..##", "##..##", "##..##", "##..##"});
  const auto first_of_sheet = static_cast<int32_t>(plain.vertices.size());
  // Its eastern end, then its western one, lie before the gap.
  const OutlineWalk walk = Walk(WithSheetAbove(plain, 4.5, 5.5));
  ASSERT_THAT(walk.gaps, SizeIs(2));
  for (const OutlineGap& gap : walk.gaps) {
    EXPECT_EQ(gap.from < first_of_sheet, gap.to < first_of_sheet) << "ground with ground, sheet with sheet";
  }
}

TEST(OutlineWalkTest, LinksChainsThatEndInside) {
  const SurveyRecord record = RecordOf({"######", "######", "##..##", "##..##", "######", "######"});
  // Without two opposite edges of the hole's rim.
  std::vector<bool> taken(record.edges.size(), true);
  std::set<int32_t> ends;
  for (size_t e = 0; e < taken.size(); ++e) {
    const Point3 &a = record.vertices[record.edges[e].from].position, &b = record.vertices[record.edges[e].to].position;
    const Point3 middle = (a + b) / 2;
    if (middle != Point3(2, 2.5, 0) && middle != Point3(4, 3.5, 0)) continue;
    taken[e] = false;
    ends.insert({record.edges[e].from, record.edges[e].to});
  }
  ASSERT_THAT(ends, SizeIs(4));
  const OutlineWalk walk = WalkOutline(record, taken, kSquare, 0.3);
  ASSERT_THAT(walk.gaps, SizeIs(2));
  for (const OutlineGap& gap : walk.gaps) {
    EXPECT_FALSE(gap.open);
    EXPECT_EQ((record.vertices[gap.from].position - record.vertices[gap.to].position).norm(), 1);
    ends.erase(gap.from), ends.erase(gap.to);
  }
  EXPECT_THAT(ends, IsEmpty());
}

// Of two pieces that overlap by 0.04 m the western one ends to the north of y = 4; a corner of the eastern one is
// missing, up to its own outline.
TEST(OutlineWalkTest, ChainsOfOverlappingPiecesAreNotTakenCrosswise) {
  SurveyRecord record;
  for (const Point2& p : std::vector<Point2>{{0, 4}, {0, 0}, {3.02, 0}, {3.02, 4}})
    record.vertices.push_back({-1, {p.x(), p.y(), 0}});
  for (const Point2& p : std::vector<Point2>{{2.98, 0}, {6, 0}, {6, 6}, {3.6, 6}, {4, 5}, {2.98, 6}})
    record.vertices.push_back({-1, {p.x(), p.y(), 0}});
  std::vector<bool> taken;
  const auto add = [&](int32_t from, int32_t to, int32_t piece, bool is_taken) {
    record.edges.push_back({from, to, piece});
    taken.push_back(is_taken);
  };
  for (const int32_t v : {0, 1, 2, 3}) add(v, (v + 1) % 4, 0, v != 2);
  for (const int32_t v : {4, 5, 6, 7, 8, 9}) add(v, v < 9 ? v + 1 : 4, 1, v != 9);
  const OutlineWalk walk = WalkOutline(record, taken, kSquare, 0.04);
  std::set<std::pair<int32_t, int32_t>> ends;
  for (const OutlineGap& gap : walk.gaps) {
    EXPECT_TRUE(gap.open);
    ends.insert({gap.from, gap.to});
  }
  EXPECT_EQ(ends, (std::set<std::pair<int32_t, int32_t>>{{7, 9}, {3, 0}}));
}

// A river's end. The west and the north are there, and the south-eastern piece up to its outline at y = 5.2, along
// which the way from the northern shore comes to the tile's outline: the gap begins there, not straight ahead.
TEST(OutlineWalkTest, AGapBeginsWhereTheOutlineOfThePieceLeads) {
  PieceRings tile;
  tile.Add({{0, 0}, {10.2, 0}, {10.2, 10}, {0, 10}}, "opoo");
  tile.Add({{9.8, 0}, {20, 0}, {20, 5.2}, {9.8, 5.2}}, "oopp");
  tile.Add({{9.8, 8}, {20, 8}, {20, 10}, {9.8, 10}}, "coop");
  std::vector<bool> taken;
  for (const char kind : tile.kinds) taken.push_back(kind != 'p');
  constexpr Outline kWide{{0, 20, 0, 10}};
  const ChainPassage passage{{}, ChainPlace{8, {10.2, 8}}, Point2(20, 5.2)};
  const OutlineWalk walk = WalkOutline(tile.record, taken, kWide, 0.6, {passage});
  ASSERT_THAT(walk.gaps, SizeIs(1));
  EXPECT_EQ(walk.gaps[0].from, tile.At(9.8, 8));
  EXPECT_EQ(walk.gaps[0].to, tile.At(20, 8));
  EXPECT_TRUE(walk.gaps[0].open);
  EXPECT_EQ(walk.gaps[0].begin, 25.2);
  EXPECT_EQ(walk.gaps[0].end, 28);
}

// Two pieces end at a lake one beside the other, the eastern one under the other; the way along the lake is the open
// one, not that between the two.
TEST(OutlineWalkTest, AShortWayInALongOneLeavesThatOpen) {
  PieceRings tile;
  tile.Add({{0, 0}, {11, 0}, {11, 10}, {10.6, 10}, {8, 9.8}, {0, 4}}, "opocco");
  tile.Add({{9, 0}, {20, 0}, {20, 10}, {10.8, 10}, {9, 9.4}}, "ooocp");
  std::vector<bool> taken;
  for (const char kind : tile.kinds) taken.push_back(kind != 'p');
  const OutlineWalk walk = WalkOutline(tile.record, taken, {{0, 20, 0, 10}}, 5);
  ASSERT_THAT(walk.gaps, SizeIs(2));
  for (const OutlineGap& gap : walk.gaps) {
    EXPECT_EQ(gap.to, gap.open ? tile.At(0, 4) : tile.At(9, 9.4)) << gap.begin;
  }
  EXPECT_NE(walk.gaps[0].open, walk.gaps[1].open);
}

// Of a bay in the eastern piece, which ends on the outline, and a corner that the western one lacks, before that end.
TEST(OutlineWalkTest, WaysOfOverlappingPiecesDoNotRunBesideEachOther) {
  PieceRings tile;
  tile.Add({{9, 0}, {20, 0}, {20, 10}, {14, 10}, {14, 7}, {9.5, 8}, {9.3, 10}, {9, 10}}, "ooocccop");
  tile.Add({{0, 0}, {11, 0}, {11, 9}, {9.2, 10}, {0, 10}}, "opcoo");
  std::vector<bool> taken;
  for (const char kind : tile.kinds) taken.push_back(kind != 'p');
  OutlineWalk walk = WalkOutline(tile.record, taken, {{0, 20, 0, 10}}, 2);
  ASSERT_THAT(walk.gaps, SizeIs(2));
  std::ranges::sort(walk.gaps, {}, &OutlineGap::begin);
  const OutlineGap &bay = walk.gaps[0], &corner = walk.gaps[1];
  EXPECT_EQ(std::pair(bay.from, bay.to), std::pair(tile.At(14, 10), tile.At(9.3, 10)));
  EXPECT_EQ(std::pair(corner.from, corner.to), std::pair(tile.At(11, 9), tile.At(9.2, 10)));
  EXPECT_GE(corner.begin, bay.end);
  EXPECT_GE(corner.end, corner.begin);
}

// Pieces that overlap from x = 3 to 3.2.
class WaysAlongPiecesTest : public ::testing::Test {
 protected:
  std::vector<OutlineGap> Gaps(const std::vector<ChainPassage>& passages = {}) const {
    std::vector<bool> taken;
    for (const char kind : tile_.kinds) taken.push_back(kind != 'p');
    return WalkOutline(tile_.record, taken, kSquare, 0.3, passages).gaps;
  }

  // The edges that ways between chains go along, by their beginnings.
  std::vector<Point2> Along(const std::vector<ChainPassage>& passages = {}) const {
    std::vector<Point2> along;
    for (const OutlineGap& gap : Gaps(passages)) {
      for (const int32_t e : gap.along) {
        along.emplace_back(tile_.record.vertices[tile_.record.edges[e].from].position.head<2>());
      }
    }
    return along;
  }

  PieceRings tile_;
};

TEST_F(WaysAlongPiecesTest, FollowTheOutlineBetweenTwoChainsOfOnePiece) {
  tile_.Add({{0, 0}, {2, 0}, {2, 1}, {3, 1.5}, {3, 3}, {3, 4}, {2, 5}, {2, 6}, {0, 6}}, "occppccoo");
  EXPECT_THAT(Along(), testing::UnorderedElementsAre(Point2(3, 1.5), Point2(3, 3)));
}

TEST_F(WaysAlongPiecesTest, GoAcrossWhereAnotherPieceIsNear) {
  // The shore of the west ends at (3.2, 4), and its outline goes on to the north. The shore of the east begins at (3,
  // 1); before that its outline comes down from (3, 3.9).
  tile_.Add({{0, 4}, {3.2, 4}, {3.2, 5}, {3.2, 6}, {0, 6}}, "cppoo");
  tile_.Add({{3, 1}, {6, 1}, {6, 6}, {3, 6}, {3, 3.9}, {3, 2}}, "cooppp");
  EXPECT_THAT(Along(), testing::UnorderedElementsAre(Point2(3, 3.9), Point2(3, 2)));
}

// The outline of the east comes to its shore around the corner at (3, 1).
TEST_F(WaysAlongPiecesTest, GoAcrossFromTheSideOfThePieceWhereTheyLeaveIt) {
  tile_.Add({{0, 4}, {3.2, 4}, {3.2, 5}, {3.2, 6}, {0, 6}}, "cppoo");
  tile_.Add({{5, 1}, {6, 1}, {6, 6}, {3, 6}, {3, 3.9}, {3, 1}}, "cooppp");
  EXPECT_THAT(Along(), testing::UnorderedElementsAre(Point2(3, 3.9), Point2(3, 1)));
  const std::vector<OutlineGap> gaps = Gaps();
  const auto linked = std::ranges::find(gaps, tile_.At(5, 1), &OutlineGap::from);
  ASSERT_NE(linked, gaps.end());
  EXPECT_EQ(linked->link, std::pair(tile_.At(3, 3.9), tile_.At(3.2, 4)));
  EXPECT_EQ(linked->from_across, 0) << "the side to the south is across the other axis";
}

// The western piece ends at x = 3 between two shores. Each of them goes on at a shore of the east that is beside the
// other one.
TEST_F(WaysAlongPiecesTest, DoNotTakeAnEdgeTwice) {
  tile_.Add({{0, 0}, {2, 0}, {2.9, 1}, {3, 1}, {3, 3}, {3, 5}, {2.9, 5}, {2, 6}, {0, 6}},
            "occpp"
            "ccoo");
  tile_.Add({{3.1, 4.9}, {3.2, 4.9}, {6, 4}, {6, 6}, {3.1, 6}}, "ccoop");
  tile_.Add({{6, 0}, {6, 2}, {3.2, 1.1}, {3.1, 1.1}, {3.1, 0}}, "occpo");
  const auto at = [](int32_t edge, double x, double y) { return ChainPlace{edge, {x, y}}; };
  const std::vector<ChainPassage> crosswise = {{at(2, 2.95, 1), at(9, 3.15, 4.9), {}},
                                               {at(16, 3.15, 1.1), at(5, 2.95, 5), {}}};
  std::vector<Point2> along = Along(crosswise);
  EXPECT_THAT(along, testing::UnorderedElementsAre(Point2(3, 1), Point2(3, 3)));
}

// Neither end of the way is compared with each vertex of an outline that leads away.
TEST_F(WaysAlongPiecesTest, FollowNoMoreThanSoManyEdges) {
  std::vector<Point2> ring = {{0, 0}, {2, 0}, {2, 1}};
  std::string kinds = "oc";
  for (int k = 0; k <= 3000; ++k) ring.emplace_back(3, 1.5 + k * 1e-3);
  kinds += "c" + std::string(3000, 'p') + "ccoo";
  ring.insert(ring.end(), {{2, 5}, {2, 6}, {0, 6}});
  tile_.Add(ring, kinds);
  EXPECT_THAT(Along(), SizeIs(2000));
}

TEST_F(WaysAlongPiecesTest, AreStraightWhereOutlinesAreNoShorterWay) {
  tile_.Add({{0, 4}, {3.2, 4}, {3.2, 5}, {3.2, 6}, {0, 6}}, "cppoo");
  tile_.Add({{3, 4}, {6, 4}, {6, 6}, {3, 6}, {3, 5}}, "coopp");
  EXPECT_THAT(Along(), IsEmpty());
}

}  // namespace
}  // namespace tilemend
