#include "coordinator/plan/overlap/clip_tile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

// The record of a tile of 6 x 6 squares stretched by 0.3 beyond its cell.
SurveyRecord RecordOf(const std::vector<std::string>& picture) {
  return OverlappingScene(picture, 6, 0.3).records.begin()->second;
}

constexpr ClipSquare kSquare{{0, 6, 0, 6}, {0, 6, 0, 6}};

ClippedTile Clip(const SurveyRecord& record) {
  return ClipTile(record, std::vector<bool>(record.edges.size(), false), kSquare);
}

std::map<double, int> Steps(const SideCover& cover) {
  std::map<double, int> steps = cover.step;
  std::erase_if(steps, [](const auto& s) { return s.second == 0; });
  return steps;
}

TEST(ClipTileTest, HasOnlyItsSidesOfAWholeTile) {
  const ClippedTile clipped = Clip(RecordOf({"######", "######", "######", "######", "######", "######"}));
  EXPECT_THAT(clipped.inner, IsEmpty());
  for (const SideCover& side : clipped.sides) EXPECT_THAT(Steps(side), ElementsAre(Pair(0, 1), Pair(6, -1)));
}

TEST(ClipTileTest, LeavesLoopsInsideAsTheyAre) {
  const SurveyRecord record = RecordOf({"######", "######", "##..##", "##..##", "######", "######"});
  const ClippedTile clipped = Clip(record);
  EXPECT_THAT(clipped.inner, SizeIs(8));
  EXPECT_EQ(std::count(clipped.cut.begin(), clipped.cut.end(), false), 8);
  EXPECT_THAT(clipped.vertices, IsEmpty());
}

TEST(ClipTileTest, CutsTheShoresOfARiverAtTheSides) {
  const SurveyRecord record = RecordOf({"######", "######", "......", "......", "######", "######"});
  const ClippedTile clipped = Clip(record);
  ASSERT_THAT(clipped.vertices, SizeIs(4));
  for (const ClipVertex& v : clipped.vertices) {
    EXPECT_TRUE(v.position.x() == 0 || v.position.x() == 6);
    EXPECT_THAT(v.through, SizeIs(1));
  }
  EXPECT_THAT(Steps(clipped.sides[kWest]), SizeIs(4));
  EXPECT_THAT(Steps(clipped.sides[kNorth]), ElementsAre(Pair(0, 1), Pair(6, -1)));
}

TEST(ClipTileTest, MakesAFoldedShoreSimple) {
  SurveyRecord record = RecordOf({"######", "######", "......", "......", "######", "######"});
  const auto at = std::find_if(record.vertices.begin(), record.vertices.end(), [](const BoundaryVertex& v) {
    return std::abs(v.position.x() - 3) < 1e-3 && v.position.y() > 1.8 && v.position.y() < 2;
  });
  ASSERT_NE(at, record.vertices.end());
  at->position += Point3(-1.7, 1, 8);  // a gable that leans back over the bank
  const ClippedTile clipped = Clip(record);
  std::map<int32_t, int> balance;
  for (const DirectedEdge& e : clipped.inner) ++balance[e.from], --balance[e.to];
  const auto own = static_cast<int32_t>(record.vertices.size());
  for (const auto& [v, more] : balance) {
    const bool on_side =
        v >= own && (clipped.vertices[v - own].position.x() == 0 || clipped.vertices[v - own].position.x() == 6);
    EXPECT_EQ(more != 0, on_side);
  }
}

TEST(ClipTileTest, CutsIslandsInTheOpen) {
  const SurveyRecord record = RecordOf({"......", "......", "..##..", "..##..", "......", "######"});
  const ClippedTile clipped = Clip(record);
  EXPECT_EQ(std::count(clipped.cut.begin(), clipped.cut.end(), false), 0);
  EXPECT_THAT(clipped.inner, SizeIs(8 + 6)) << "around the island, and the shore";
}

TEST(ClipTileTest, MovesAnOutlineShortOfTheSideToIt) {
  const SurveyRecord record =
      OverlappingScene({"######", "######", "######", "######", "######", "######"}, 6, -0.1).records.begin()->second;
  const ClipSquare square{{0, 6, 0, 6}, {record.lo.x(), record.hi.x(), record.lo.y(), record.hi.y()}};
  const ClippedTile clipped = ClipTile(record, std::vector<bool>(record.edges.size(), false), square);
  EXPECT_THAT(clipped.inner, IsEmpty());
  for (const SideCover& side : clipped.sides) EXPECT_THAT(Steps(side), ElementsAre(Pair(0, 1), Pair(6, -1)));
}

// Nothing but what is outside the area: no surface of the tile, and vertices without heights.
TEST(ClipTileTest, TellsWhatIsOutsideTheAreaFromSurface) {
  const SurveyRecord record = RecordOf({"######", "######", "......", "......", "......", "......"});
  const AreaOutside outside{{0, 6, 0, 6}, {{0, 0}, {6, 0}, {6, 1}, {0, 1}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  const ClippedTile clipped = ClipTile(record, std::vector<bool>(record.edges.size(), false), kSquare, outside);
  EXPECT_THAT(Steps(clipped.sides[kSouth]), ElementsAre(Pair(0, 1), Pair(6, -1)));
  for (const auto& [t, step] : clipped.sides[kSouth].of_tile) EXPECT_EQ(step, 0) << t;
  EXPECT_THAT(Steps(clipped.sides[kNorth]), ElementsAre(Pair(0, 1), Pair(6, -1)));
  EXPECT_EQ(clipped.sides[kNorth].of_tile, clipped.sides[kNorth].step);
  for (const ClipVertex& v : clipped.vertices) EXPECT_EQ(v.outside, v.through.empty()) << v.position.transpose();
}

// A hole that touches a side there takes away what lies beyond it.
TEST(ClipTileTest, AHoleAtASideTakesAwayFromIt) {
  AreaOutside outside{{0, 6, 0, 6}, {}, {}};
  outside.points = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 0}, {2, 1}, {4, 1}, {4, 0}};
  outside.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
  const ClippedTile clipped = ClipTile({}, {}, kSquare, outside);
  EXPECT_THAT(Steps(clipped.sides[kSouth]), ElementsAre(Pair(0, 1), Pair(2, -1), Pair(4, 1), Pair(6, -1)));
}

}  // namespace
}  // namespace tilemend
