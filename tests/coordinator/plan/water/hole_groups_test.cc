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

TEST(RimVerticesOfTest, AreTheOriginalOnesOfTheHoles) {
  const Plan plan = TwoCells();
  for (const std::vector<int32_t>& group : GroupHoles(plan)) {
    const std::vector<int32_t> rim = RimVerticesOf(plan, group);
    EXPECT_EQ(rim.size(), group.size() == 1 ? 4u : 12u);
    for (const int32_t v : rim) EXPECT_GE(plan.vertices[v].index, 0);
  }
}

TEST(GroupsCoveringTest, AHoleIsInTheGroupThatCoversMostOfItInItsCell) {
  const Plan whole = TwoCells();
  std::vector<int32_t> group_of;
  for (const PlannedHole& hole : whole.holes) group_of.push_back(hole.kind == HoleKind::kClosed ? 4 : 7);
  EXPECT_EQ(GroupsCovering(whole, whole, group_of), group_of);
  Plan moved = whole;
  for (PlannedHole& hole : moved.holes) hole.cell.row += 1;
  EXPECT_EQ(GroupsCovering(moved, whole, group_of), std::vector<int32_t>(3, -1));
  moved = whole;
  for (PlanVertex& v : moved.vertices) v.position.y() += 1.2;  // of the 2 m that the open holes are high
  EXPECT_EQ(GroupsCovering(moved, whole, group_of), std::vector<int32_t>(3, -1));
  moved = whole;
  for (PlannedHole& hole : moved.holes) hole.failure = "it crosses itself";
  EXPECT_EQ(GroupsCovering(moved, whole, group_of), std::vector<int32_t>(3, -1));
  EXPECT_EQ(GroupsCovering(whole, whole, {-1, -1, -1}), std::vector<int32_t>(3, -1));
}

}  // namespace
}  // namespace tilemend
