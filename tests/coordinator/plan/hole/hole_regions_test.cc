#include "coordinator/plan/hole/hole_regions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

FoundHoles Find(const HoleScene& scene) { return FindHoles(scene.Site(), scene.boundary); }

TEST(FindHolesTest, FindsClosedHolesInTheOrderOfTheirLoops) {
  const HoleScene scene({HoleLoop(1, 1, 3, 3), HoleLoop(5, 5, 9, 9)});
  const FoundHoles found = Find(scene);
  ASSERT_EQ(found.holes.size(), 2U);
  EXPECT_EQ(found.holes[0].area, 4);
  EXPECT_EQ(found.holes[1].area, 16);
  for (const PlannedHole& hole : found.holes) {
    EXPECT_EQ(hole.kind, HoleKind::kClosed);
    EXPECT_TRUE(hole.projects);
  }
}

TEST(FindHolesTest, MakesAPieceAnIslandOfTheHoleThatItLiesIn) {
  const HoleScene scene({HoleLoop(1, 1, 9, 9), PieceLoop(4, 4, 5, 6)});
  const FoundHoles found = Find(scene);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes[0].area, 64 - 2);
  EXPECT_EQ(found.holes[0].segments.size(), 8U);
  EXPECT_EQ(found.holes[0].single, SingleType::kIsland);
  EXPECT_EQ(found.outer_rims, 0);
}

TEST(FindHolesTest, MakesAPieceAnIslandOfTheInnermostHole) {
  const std::vector<Loop3> nested = {HoleLoop(1, 1, 9, 9), PieceLoop(2, 2, 8, 8), HoleLoop(3, 3, 7, 7),
                                     PieceLoop(4, 4, 5, 5)};
  for (const bool reversed : {false, true}) {
    std::vector<Loop3> loops = nested;
    if (reversed) std::reverse(loops.begin(), loops.end());
    FoundHoles found = Find(HoleScene(loops));
    ASSERT_EQ(found.holes.size(), 2U);
    std::sort(found.holes.begin(), found.holes.end(), [](const auto& a, const auto& b) { return a.area < b.area; });
    EXPECT_EQ(found.holes[0].area, 16 - 1);
    EXPECT_EQ(found.holes[1].area, 64 - 36);
  }
}

TEST(FindHolesTest, LeavesAPieceInNoHoleAsAnOuterRim) {
  const HoleScene scene({HoleLoop(1, 1, 3, 3), PieceLoop(6, 6, 8, 8)});
  const FoundHoles found = Find(scene);
  EXPECT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.outer_rims, 1);
  ASSERT_EQ(found.left.size(), 1U);
  EXPECT_FALSE(found.left[0].is_hole);
  EXPECT_EQ(found.left[0].edges, 4);
}

TEST(FindHolesTest, MakesAPieceAnIslandOfAnOpenHole) {
  HoleScene scene({PieceLoop(0, 2, 6, 8), PieceLoop(3, 4, 4, 5)});
  scene.boundary.closed_loops.erase(scene.boundary.closed_loops.begin());
  for (int32_t i = 0; i < 4; ++i)
    scene.boundary.open.push_back({{i, (i + 1) % 4, i == 3}, i == 3 ? kWest : -1, {-1, 0}});
  const FoundHoles found = Find(scene);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_EQ(found.holes[0].kind, HoleKind::kOpenII);
  EXPECT_EQ(found.holes[0].area, 36 - 1);
  EXPECT_EQ(found.outer_rims, 0);
}

// A hole along the west side whose boundary folds over itself at its far end, as that of a tree does.
TEST(FindHolesTest, MakesAPieceAnIslandOfAnOpenHoleThatFolds) {
  const Loop3 folded = {{0, 2, 0}, {6, 2, 0}, {6, 6, 0}, {7, 5, 0}, {5, 5.5, 0}, {5, 8, 0}, {0, 8, 0}};
  HoleScene scene({folded, PieceLoop(3, 4, 4, 5)});
  scene.boundary.closed_loops.erase(scene.boundary.closed_loops.begin());
  const auto count = static_cast<int32_t>(folded.size());
  for (int32_t i = 0; i < count; ++i) {
    const bool seam = i + 1 == count;
    scene.boundary.open.push_back({{i, (i + 1) % count, seam}, seam ? kWest : -1, {-1, 0}});
  }
  const FoundHoles found = Find(scene);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_FALSE(found.holes[0].projects);
  EXPECT_EQ(found.holes[0].segments.size(), folded.size() + 4);
  EXPECT_EQ(found.outer_rims, 0);
}

// A wall in the plane y = 5 that faces south, with a hole; a piece of the wall in it.
TEST(FindHolesTest, MakesAPieceOfAWallAnIslandOfItsHole) {
  const auto upright = [](Loop3 loop) {
    for (Point3& p : loop) p = Point3(p.x(), 5, p.y());
    return loop;
  };
  HoleScene scene({upright(HoleLoop(1, 1, 9, 9)), upright(PieceLoop(4, 4, 5, 6))});
  for (RimPoint& p : scene.rim.points) p.normal = Eigen::Vector3d(0, -1, 0);
  const FoundHoles found = Find(scene);
  ASSERT_EQ(found.holes.size(), 1U);
  EXPECT_FALSE(found.holes[0].projects);
  EXPECT_DOUBLE_EQ(found.holes[0].area, 64 - 2);
}

TEST(FindHolesTest, DoesNotDependOnTheOrderOfLoops) {
  const std::vector<Loop3> loops = {HoleLoop(1, 1, 4, 4), PieceLoop(2, 2, 3, 3), HoleLoop(5, 5, 9, 9),
                                    PieceLoop(6, 1, 7, 2)};
  const HoleScene scene(loops), reversed({loops.rbegin(), loops.rend()});
  const auto areas = [](const FoundHoles& found) {
    std::multiset<double> sorted;
    for (const PlannedHole& hole : found.holes) sorted.insert(hole.area);
    return sorted;
  };
  EXPECT_EQ(areas(Find(scene)), areas(Find(reversed)));
  EXPECT_EQ(Find(scene).outer_rims, Find(reversed).outer_rims);
}

}  // namespace
}  // namespace tilemend
