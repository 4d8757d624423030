#include "coordinator/plan/water/clear_shores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

// A square of water at a level of 2 m whose rim has these heights.
class ClearShoresTest : public ::testing::Test {
 protected:
  ClearShoresTest() {
    plan_.lattice_step = 1.0 / 1024;
    const Point3 rim[] = {{0, 0, 2.5}, {10, 0, 2.01}, {10, 10, 1.9}, {0, 10, 2}};
    PlannedHole& hole = plan_.holes.emplace_back();
    for (int32_t v = 0; v < 4; ++v) {
      plan_.vertices.push_back({{0, 0}, v, rim[v]});
      hole.segments.push_back({v, (v + 1) % 4});
    }
    plan_.vertices[3].index = -1;  // of a seam
    plan_.water.emplace_back();
    plan_.water[0].holes = {0};
    plan_.water[0].level = 2;
    hole.water = 0;
  }

  std::vector<bool> Marked(std::vector<WaterArea> areas) {
    MarkClearedShores(areas, plan_);
    std::vector<bool> marked;
    for (const PlanVertex& v : plan_.vertices) marked.push_back(v.on_object);
    return marked;
  }

  static WaterArea Over(double x0, double x1, bool clear) {
    return {true, {{{{x0, -1}, {x1, -1}, {x1, 11}, {x0, 11}}}}, 2.0, {}, "pond", WaterKind::kUnsaid, clear};
  }

  Plan plan_;
};

TEST_F(ClearShoresTest, MarksWhatIsOffTheWater) {
  EXPECT_THAT(Marked({Over(-1, 11, true)}), ElementsAre(true, false, true, false));
}

TEST_F(ClearShoresTest, LeavesOtherWaterAsItIs) {
  EXPECT_THAT(Marked({}), ElementsAre(false, false, false, false));
  EXPECT_THAT(Marked({Over(-1, 11, false)}), ElementsAre(false, false, false, false));
  EXPECT_THAT(Marked({Over(-1, 4, true)}), ElementsAre(false, false, false, false)) << "less than half";
  EXPECT_THAT(Marked({Over(-1, 11, true), Over(-1, 11, false)}), ElementsAre(false, false, false, false));
}

// A cell of 100 m: surface was taken out of it under the area.
TEST_F(ClearShoresTest, ACellWithoutAHoleWhereSurfaceWentIsLeft) {
  const Grid grid{{0, 0}, {100, 100}};
  WaterArea area = Over(-1, 30, true);
  const auto left = [&] {
    plan_.left.clear();
    LeaveClearedCells(grid, {area}, plan_);
    return plan_.left.size();
  };
  EXPECT_EQ(left(), 0U) << "nothing was taken out";
  area.cleared_cells = {{0, 0}};
  EXPECT_EQ(left(), 0U) << "the hole is there";
  plan_.holes.clear();
  ASSERT_EQ(left(), 1U);
  EXPECT_EQ(plan_.left[0].cell, (CellId{0, 0}));
  EXPECT_TRUE(plan_.left[0].is_hole);
  EXPECT_THAT(plan_.left[0].reason, ::testing::HasSubstr("pond took surface out of it"));
  area.cleared_cells = {{0, 1}};
  EXPECT_EQ(left(), 0U) << "the area does not reach that cell: an overlap of its tile does";
}

}  // namespace
}  // namespace tilemend
