#include "coordinator/plan/water/hole_groups.h"

#include <gtest/gtest.h>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

// Two cells side by side with one open cluster between them and a closed hole in the left one.
Plan TwoCells(const HeightFunction& height = Flat) {
  return MakePlan(PictureScene({"########|########",  //
                                "#.######|########",  //
                                "########|########",  //
                                "######..|..######",  //
                                "######..|..######",  //
                                "########|########",  //
                                "########|########",  //
                                "########|########"},
                               8, height)
                      .Input(),
                  {});
}

TEST(GroupHolesTest, AClusterIsOneGroupAndAClosedHoleAnother) {
  const Plan plan = TwoCells();
  const std::vector<std::vector<int32_t>> groups = GroupHoles(plan);
  ASSERT_EQ(groups.size(), 2u);
  size_t closed = 0, open = 0;
  for (const std::vector<int32_t>& group : groups) {
    const bool is_closed = plan.holes[group[0]].kind == HoleKind::kClosed;
    (is_closed ? closed : open) += group.size();
  }
  EXPECT_EQ(closed, 1u);
  EXPECT_EQ(open, 2u);
}

TEST(GroupHolesTest, AClosedHoleInASteepWallIsInNone) {
  const std::vector<std::vector<int32_t>> groups = GroupHoles(TwoCells([](double x, double) { return 3 * x; }));
  EXPECT_EQ(groups.size(), 1u);
}

TEST(BoundaryOfTest, HasTheSegmentsOfAllHoles) {
  const Plan plan = TwoCells();
  for (const std::vector<int32_t>& group : GroupHoles(plan)) {
    size_t segments = 0;
    for (const int32_t h : group) segments += plan.holes[h].segments.size();
    EXPECT_EQ(BoundaryOf(plan, group).size(), segments);
  }
}

}  // namespace
}  // namespace tilemend
