#include "coordinator/plan/pieces/outline_chains.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/rim_builders.h"

namespace tilemend {
namespace {

constexpr CellId kTile{0, 0}, kEast{1, 0}, kNorth{0, 1};

// The outline of a tile of 10 m, surface on the left, with a bay of `depth` metres in its east side from y = 3 to 6.
struct BayScene {
  explicit BayScene(double depth)
      : rim(RimOf({{{0, 0, 0},
                    {10, 0, 0},
                    {10, 3, 0},
                    {10 - depth, 3, 0},
                    {10 - depth, 6, 0},
                    {10, 6, 0},
                    {10, 10, 0},
                    {0, 10, 0}}})),
        closing(rim.edges.size(), kEast),
        piece_border(rim.edges.size(), -1) {
    for (const int32_t e : {2, 3, 4}) closing[e] = kTile;
  }

  OutlineChains Close() const { return CloseChains(rim.loops[0], rim, lines, closing, piece_border); }

  GridLines lines = LinesOf({kTile}, 10);
  Rim rim;
  ClosingCells closing;
  std::vector<double> piece_border;
};

TEST(CloseChainsTest, ClosesARunOffTheOutlineByAStraightSegment) {
  const OutlineChains chains = BayScene(2).Close();
  ASSERT_EQ(chains.loops.size(), 1U);
  ASSERT_EQ(chains.loops[0].size(), 4U);
  EXPECT_EQ(chains.loops[0].front().from, 5) << "against the edges: the hole is on the left";
  EXPECT_TRUE(chains.loops[0].back().seam);
  EXPECT_EQ(chains.loops[0].back().from, 2);
  EXPECT_EQ(chains.loops[0].back().to, 5);
  EXPECT_TRUE(chains.open_runs.empty());
  EXPECT_TRUE(chains.left.empty());
}

TEST(CloseChainsTest, GivesTheSameWhereverTheLoopStarts) {
  BayScene scene(2);
  const OutlineChains before = scene.Close();
  for (size_t turn = 0; turn < 8; ++turn) {
    std::rotate(scene.rim.loops[0].begin(), scene.rim.loops[0].begin() + 1, scene.rim.loops[0].end());
    const OutlineChains after = scene.Close();
    ASSERT_EQ(after.loops.size(), 1U);
    for (size_t k = 0; k < 4; ++k) EXPECT_EQ(after.loops[0][k].from, before.loops[0][k].from);
  }
}

TEST(CloseChainsTest, LeavesRunsBetweenTwoSidesOpen) {
  BayScene scene(2);
  // From the east side all the way to the north side.
  scene.rim.points[5].position = Point3(6, 10, 5);
  scene.closing[5] = kNorth;
  const OutlineChains chains = scene.Close();
  EXPECT_TRUE(chains.loops.empty());
  ASSERT_EQ(chains.open_runs.size(), 1U);
  EXPECT_EQ(chains.open_runs[0], (std::vector<int32_t>{2, 3, 4}));
}

TEST(CloseChainsTest, LeavesSingleEdgesOffTheOutline) {
  BayScene scene(2);
  for (const int32_t e : {2, 4}) scene.closing[e] = kEast;
  const OutlineChains chains = scene.Close();
  EXPECT_TRUE(chains.loops.empty());
  ASSERT_EQ(chains.left.size(), 1U);
  EXPECT_EQ(chains.left[0].edges, 1);
}

TEST(CloseChainsTest, CountsEdgesAlongOtherPiecesAsNoHoles) {
  BayScene scene(2);
  scene.piece_border[7] = 0.25;
  scene.piece_border[0] = 0.75;
  const OutlineChains chains = scene.Close();
  EXPECT_EQ(chains.loops.size(), 1U);
  ASSERT_EQ(chains.left.size(), 1U);
  EXPECT_EQ(chains.left[0].edges, 2);
  EXPECT_FALSE(chains.left[0].is_hole);
}

}  // namespace
}  // namespace tilemend
