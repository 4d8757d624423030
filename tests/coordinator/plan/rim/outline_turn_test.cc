#include "coordinator/plan/rim/outline_turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

// Overlapping tiles with waters, in a frame that is turned against their grid.
SurveyedScene Turned(double angle) {
  const SurveyedScene scene = OverlappingScene(kWaters, 10, 0.1);
  std::map<CellId, TriMesh> tiles;
  for (const auto& [cell, tile] : scene.tiles) {
    tiles[cell] = Moved(tile, [&](const Point3& p) {
      return RoundedTo(NumberType::kFloat32, Point3(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                                                    std::sin(angle) * p.x() + std::cos(angle) * p.y(), p.z()));
    });
  }
  return SurveyScene(scene.grid, std::move(tiles));
}

TEST(OutlineTurnTest, TellsTheTurnOfTheTiles) {
  for (const double angle : {0.0178, -0.05, 0.002}) {
    const SurveyedScene scene = Turned(angle);
    EXPECT_NEAR(TurnOfTiles(scene.Input()), angle, 2e-4);
  }
}

TEST(OutlineTurnTest, IsNoneAlongTheAxes) {
  for (const double angle : {0.0, 1e-4, std::numbers::pi / 4}) {
    const SurveyedScene scene = Turned(angle);
    EXPECT_EQ(TurnOfTiles(scene.Input()), 0) << angle;
  }
  EXPECT_EQ(TurnOfTiles(PlanInput()), 0);
}

// Shores in all directions.
TEST(OutlineTurnTest, IsNoneWithoutStraightOutlines) {
  const SurveyedScene scene = SurveyScene(Grid{{-10, -10}, {20, 20}}, {{{0, 0}, DiscMesh(3, 61)}});
  EXPECT_EQ(TurnOfTiles(scene.Input()), 0);
}

}  // namespace
}  // namespace tilemend
