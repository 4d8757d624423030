#include "coordinator/plan/hole/piece_boundaries.h"

#include <gtest/gtest.h>

#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

// A hole in a piece, and a piece of its own.
TEST(PieceBoundariesTest, TellWhetherAPieceReachesBeyondItsLoop) {
  HoleScene scene({HoleLoop(1, 1, 4, 3), PieceLoop(0, 0, 9, 9), PieceLoop(2, 2, 3, 2.5)});
  SurveyRecord record;
  for (const RimPoint& p : scene.rim.points) record.vertices.push_back({p.index, p.position, p.normal, 0});
  for (size_t e = 0; e < scene.rim.edges.size(); ++e) {
    record.edges.push_back({scene.rim.edges[e].from, scene.rim.edges[e].to, e < 8 ? 0 : 1});
  }
  const StoredRecord stored(&record);
  scene.boundary.surface = &stored;
  const HoleSite site = scene.Site();
  PieceBoundaries pieces(site, scene.boundary);
  EXPECT_EQ(pieces.ReachBeyond(scene.boundary.closed_loops[0]), true);
  EXPECT_EQ(pieces.ReachBeyond(scene.boundary.closed_loops[1]), false);
  EXPECT_EQ(pieces.ReachBeyond(scene.boundary.closed_loops[2]), false);
}

TEST(PieceBoundariesTest, SayNothingOfWhatTheTileDoesNotHave) {
  HoleScene scene({HoleLoop(1, 1, 4, 3)});
  const HoleSite site = scene.Site();
  PieceBoundaries without(site, scene.boundary);
  EXPECT_EQ(without.ReachBeyond(scene.boundary.closed_loops[0]), std::nullopt);
  const SurveyRecord record;
  const StoredRecord stored(&record);
  scene.boundary.surface = &stored;
  PieceBoundaries empty(site, scene.boundary);
  EXPECT_EQ(empty.ReachBeyond(scene.boundary.closed_loops[0]), std::nullopt);
}

}  // namespace
}  // namespace tilemend
