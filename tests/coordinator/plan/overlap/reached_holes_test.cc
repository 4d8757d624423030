#include "coordinator/plan/overlap/reached_holes.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Pairs = std::vector<std::pair<int32_t, int32_t>>;

const std::vector<bool> kOpen = {true, true};

// A hole in the western cell whose own region goes on to x = 10 + `reach`, and one in the eastern cell around (12, 5),
// in a plan with edges of 2 m. They share no seam.
Plan TwoHoles(double reach) {
  Plan plan;
  const auto add = [&](const Point3& position, int32_t index, int32_t follows) {
    PlanVertex v;
    v.position = position;
    v.index = index;
    v.follows = follows;
    v.size = 2;
    plan.vertices.push_back(v);
    return static_cast<int32_t>(plan.vertices.size()) - 1;
  };
  const auto ring = [](const std::vector<int32_t>& corners) {
    std::vector<RimSegment> segments;
    for (size_t i = 0; i < corners.size(); ++i) {
      segments.push_back({corners[i], corners[(i + 1) % corners.size()], false});
    }
    return segments;
  };
  const int32_t tip = add({8, 5, 0}, 0, -1), south = add({10, 4, 0}, -1, -1), north = add({10, 6, 0}, -1, -1);
  const int32_t beyond_south = add({10 + reach, 4, 0}, -1, south), beyond_north = add({10 + reach, 6, 0}, -1, north);
  PlannedHole west, east;
  west.cell = {0, 0};
  west.segments = ring({tip, south, north});
  west.own_regions = {ring({tip, beyond_south, beyond_north})};
  east.cell = {1, 0};
  east.kind = HoleKind::kOpenI;
  east.segments =
      ring({add({11, 3, 0}, 0, -1), add({14, 3, 0}, 1, -1), add({14, 8, 0}, 2, -1), add({11, 8, 0}, 3, -1)});
  plan.holes = {west, east};
  return plan;
}

TEST(HolesReachedTest, AnOwnRegionReachesIntoTheNeighboursHole) {
  EXPECT_EQ(HolesReached(TwoHoles(2), kOpen, {}), (Pairs{{0, 1}}));
  EXPECT_EQ(HolesReached(TwoHoles(5), kOpen, {}), Pairs()) << "beyond it";
}

TEST(HolesReachedTest, NotByLessThanHalfAnEdge) {
  Plan plan = TwoHoles(0.9);
  for (int32_t v = 0; v < 4; ++v) plan.vertices[plan.holes[1].segments[v].from].position.x() -= 2;
  EXPECT_FALSE(IsFarOff(plan, 3));
  EXPECT_EQ(HolesReached(plan, kOpen, {}), Pairs());
}

TEST(HolesReachedTest, HolesThatTouchAnywayAreNotNamed) {
  EXPECT_EQ(HolesReached(TwoHoles(2), kOpen, {{0, 1}}), Pairs());
}

TEST(HolesReachedTest, NotGroundIntoWaterNorHolesThatStayOpen) {
  Plan plan = TwoHoles(2);
  plan.holes[1].water = 0;
  EXPECT_EQ(HolesReached(plan, kOpen, {}), Pairs());
  plan.holes[1].water = -1;
  EXPECT_EQ(HolesReached(plan, {true, false}, {}), Pairs());
}

}  // namespace
}  // namespace tilemend
