#include "coordinator/report/scene_sight.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(SceneSightTest, SaysWhereTilesLie) {
  Scene scene;
  scene.root = "/scene";
  scene.tiles = {{{1, 0}, "a.obj"}, {{0, 1}, ""}, {{2, 1}, "t/b.osgb"}};
  scene.tiles[2].delivered = "t/b.json";
  scene.tiles[2].frame = TileFrame(16, 0.5);
  const SceneSight sight(scene);
  EXPECT_EQ(sight.root(), "/scene");
  EXPECT_EQ(sight.cells().At({1, 0}), SceneSight::kWithTile);
  EXPECT_EQ(sight.cells().At({0, 1}), SceneSight::kWithoutSurface);
  EXPECT_EQ(sight.cells().At({0, 0}), CellLetters::kNone);
  EXPECT_EQ(sight.TileOf({1, 0}, false)->path, "a.obj");
  EXPECT_EQ(sight.TileOf({1, 0}, true)->path, "a.obj");
  EXPECT_FALSE(sight.TileOf({0, 1}, false));
  EXPECT_EQ(sight.TileOf({0, 1}, true)->path, "tiles/Tile_+000_+001.ply");
  EXPECT_EQ(sight.TileOf({2, 1}, false)->path, "t/b.osgb");
  EXPECT_EQ(sight.TileOf({2, 1}, true)->path, "t/b.json");
  EXPECT_EQ(sight.TileOf({2, 1}, true)->frame, scene.tiles[2].frame);
  EXPECT_FALSE(sight.TileOf({7, 7}, false));
}

TEST(SceneSightTest, HasHolesOnceTheyArePlanned) {
  SceneSight sight((Scene()));
  EXPECT_EQ(sight.planned_holes(), nullptr);
  Plan plan;
  plan.holes.resize(1);
  sight.SetPlan(plan, {});
  EXPECT_NE(sight.planned_holes()->find("\"holeCount\":1"), std::string::npos);
}

}  // namespace
}  // namespace tilemend
