#include "worker/fill/plane/plane_heights.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

// One new point in the middle of a square hole in ground that slopes by 0.5 along x.
TEST(PlaneHeightsTest, GoesOnWithAPlane) {
  const auto shape = [](const Point3& p) { return Point3(p.x(), p.y(), 0.5 * p.x()); };
  const CellHoles work = WorkOfSheet(Disc(1, -4, 1.2), shape, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  PlanePatch start;
  start.points = hole.positions;
  start.points.emplace_back(1, -4, 99);
  for (const RegionSegment& s : hole.segments) start.triangles.push_back({s.from, s.to, hole.size()});
  start.has_equation = hole.has_equation;
  for (const RimUse use : {RimUse::kWhole, RimUse::kPart}) {
    PlanePatch patch = start;
    std::optional<HoldOut> chosen;
    ASSERT_TRUE(FindHeights(hole, ProjectionFrame::Upright(), FillOptions(), use, patch, chosen));
    EXPECT_EQ(patch.triangles, start.triangles);
    ASSERT_EQ(patch.points.size(), start.points.size());
    for (int32_t v = 0; v < hole.size(); ++v) EXPECT_EQ(patch.points[v], start.points[v]);
    EXPECT_NEAR(patch.points.back().z(), 0.5, 1e-9);
    EXPECT_EQ(chosen.has_value(), use == RimUse::kWhole);
  }
}

}  // namespace
}  // namespace tilemend
