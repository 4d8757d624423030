#include "coordinator/plan/overlap/lost_region.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

// Adds a box to the plan; gives its boundary, the inside on the left.
std::vector<RimSegment> Box(double x0, double y0, double x1, double y1, Plan& plan) {
  std::vector<RimSegment> segments;
  const auto base = static_cast<int32_t>(plan.vertices.size());
  for (const Point2& p : {Point2(x0, y0), Point2(x1, y0), Point2(x1, y1), Point2(x0, y1)}) {
    plan.vertices.emplace_back().position = Point3(p.x(), p.y(), 0);
  }
  for (int32_t k = 0; k < 4; ++k) segments.push_back({base + k, base + (k + 1) % 4, false});
  return segments;
}

TEST(IsLostRegionTest, WhereMuchOfTheHoleIsMissing) {
  Plan plan;
  const auto hole = Box(1e6, 0, 1e6 + 20, 10, plan);
  EXPECT_FALSE(IsLostRegion(plan, hole, Box(1e6 - 1, -1, 1e6 + 21, 11, plan), true));
  EXPECT_FALSE(IsLostRegion(plan, hole, Box(1e6, 0, 1e6 + 18.5, 10, plan), true));
  EXPECT_TRUE(IsLostRegion(plan, hole, Box(1e6, 0, 1e6 + 17, 10, plan), true));
  EXPECT_TRUE(IsLostRegion(plan, hole, {}, true));
}

TEST(IsLostRegionTest, SmallHolesMayLoseAll) {
  Plan plan;
  EXPECT_FALSE(IsLostRegion(plan, Box(0, 0, 1.4, 1.4, plan), {}, true));
}

TEST(IsLostRegionTest, WhereNothingIsLeftOfTheBoundary) {
  Plan plan;
  const auto hole = Box(0, 0, 1, 1, plan);
  auto region = hole;
  for (RimSegment& s : region) s.seam = true;
  EXPECT_TRUE(IsLostRegion(plan, hole, region, false));
  EXPECT_FALSE(IsLostRegion(plan, hole, region, true)) << "a tile within a lake";
  EXPECT_FALSE(IsLostRegion(plan, region, region, false)) << "an area within a lake";
  region.front().seam = false;
  EXPECT_FALSE(IsLostRegion(plan, hole, region, false));
}

TEST(IsSliverTest, WhatIsNarrowerThanPiecesOverlap) {
  Plan plan;
  const auto strip = Box(1e6, 0, 1e6 + 20, 0.2, plan);
  EXPECT_TRUE(IsSliver(plan, strip, 0.21));
  EXPECT_FALSE(IsSliver(plan, strip, 0.19));
  EXPECT_FALSE(IsSliver(plan, Box(0, 0, 1, 1, plan), 0.25)) << "small, but a hole";
  const auto wall = Box(0, 0, 0.05, 5, plan);
  for (PlanVertex& v : plan.vertices) v.position = Point3(v.position.x(), 0, v.position.y());
  EXPECT_TRUE(IsSliver(plan, wall, 0.06)) << "upright";
  EXPECT_FALSE(IsSliver(plan, wall, 0.04));
}

// Two vertices are on a seam, without a height, and the others 800 m above the sea.
TEST(IsSliverTest, IsSeenFromAboveBesideASeam) {
  Plan plan;
  auto strip = Box(0, 0, 20, 0.01, plan);
  strip[0].seam = true;
  for (const int32_t v : {strip[2].from, strip[3].from}) plan.vertices[v].position.z() = 800;
  EXPECT_TRUE(IsSliver(plan, strip, 0.02));
}

}  // namespace
}  // namespace tilemend
