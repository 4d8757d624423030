#include "client/demo_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/inspection.h"
#include "common/util/files.h"
#include "coordinator/report/tile_checks.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(DemoSceneTest, HasALakeOverSeveralCellsAndSmallHoles) {
  const TemporaryFolder folder;
  ASSERT_TRUE(WriteDemoScene(folder.path()).ok());
  auto scene = LoadScene(folder.path(), ReadTileHull);
  ASSERT_TRUE(scene.ok()) << scene.status();
  const Inspection inspection = InspectScene(*std::move(scene), {});
  EXPECT_TRUE(inspection.errors.empty());
  const Plan& plan = inspection.waves->plan();
  ASSERT_EQ(plan.water.size(), 1u);
  EXPECT_NEAR(plan.water[0].level, kDemoLakeLevel, 0.05);
  int open = 0, closed = 0;
  for (const PlannedHole& hole : plan.holes) (hole.kind == HoleKind::kClosed ? closed : open) += 1;
  EXPECT_EQ(closed, 6);
  EXPECT_EQ(open, 4);
}

TEST(DemoSceneTest, IsTheSameEachTime) {
  const TemporaryFolder a, b;
  ASSERT_TRUE(WriteDemoScene(a.path()).ok());
  ASSERT_TRUE(WriteDemoScene(b.path()).ok());
  for (const char* file : {"/scene.json", "/tiles/Tile_+001_+000.ply"}) {
    EXPECT_EQ(*ReadFile(a.path() + file), *ReadFile(b.path() + file)) << file;
  }
}

}  // namespace
}  // namespace tilemend
