#include "coordinator/plan/rim/buffered_cut.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/buffered_scene.h"

namespace tilemend {
namespace {

std::optional<Buffers> Find(const SurveyedScene& scene, CellId a, Side side) {
  return FindBuffers(scene.records.at(a), scene.records.at(Across(a, side)), scene.grid, a, side);
}

const std::vector<std::string> kWhole(20, "##########|##########");

TEST(FindBuffersTest, SaysHowFarBeyondTheLineTheZigzagsBegin) {
  for (const double margin : {0.25, 1.0}) {
    const SurveyedScene scene = BufferedScene(kWhole, 10, margin);
    for (const Side side : {kEast, kNorth}) {
      const auto found = Find(scene, {0, 0}, side);
      ASSERT_TRUE(found.has_value());
      for (const auto& beyond : *found) {
        EXPECT_GT(*beyond, margin);
        EXPECT_LT(*beyond, margin + 1);
      }
    }
  }
}

TEST(FindBuffersTest, RimsThatBothHaveAreNoZigzag) {
  const SurveyedScene scene = BufferedScene(kWaters, 10, 1);
  for (const Side side : {kEast, kNorth}) {
    const auto found = Find(scene, {0, 0}, side);
    ASSERT_TRUE(found.has_value());
    for (const auto& beyond : *found) EXPECT_GT(*beyond, 1);
  }
}

TEST(FindBuffersTest, FindsNoneWhereTilesMeet) {
  for (const bool ragged : {false, true}) {
    SurveyedScene scene = PictureScene(kWaters, 10);
    if (ragged) {
      for (auto& [cell, tile] : scene.tiles) {
        tile = Moved(tile, [](const Point3& p) {
          return Point3(p + Point3(0.4 * std::sin(7 * p.y()), 0.4 * std::sin(7 * p.x()), 0));
        });
      }
      scene = SurveyScene(scene.grid, scene.tiles);
    }
    for (const Side side : {kEast, kNorth}) EXPECT_FALSE(Find(scene, {0, 0}, side).has_value());
  }
}

TEST(FindBuffersTest, MakeTheSceneOneOfTilesThatOverlap) {
  for (const double margin : {0.0, 0.25, 1.0}) {
    const SurveyedScene scene = BufferedScene(kWaters, 10, margin);
    const BorderFindings found = AuditBorders(scene.Input());
    EXPECT_TRUE(found.independent);
    for (const BorderAudit& border : found.borders) {
      EXPECT_EQ(border.kind, BorderKind::kOverlap);
      EXPECT_EQ(border.apart.median, 0);
    }
  }
}

}  // namespace
}  // namespace tilemend
