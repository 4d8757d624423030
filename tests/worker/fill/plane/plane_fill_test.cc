#include "worker/fill/plane/plane_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

double Slope(double x, double y) { return 0.4 * x - 0.2 * y; }

class PlaneFillTest : public testing::TestWithParam<Surface> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, PlaneFillTest, testing::Values(Surface::kWang, Surface::kThinPlate));

TEST_P(PlaneFillTest, GoesOnWithASlope) {
  const auto shape = [](const Point3& p) { return Point3(p.x(), p.y(), Slope(p.x(), p.y())); };
  const CellHoles work = WorkOfSheet(Disc(2, 5, 4), shape, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = FillOverPlane(hole, ProjectionFrame::Upright(), With(GetParam()), {});
  ASSERT_TRUE(patch.ok());
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_NEAR(p.z(), Slope(p.x(), p.y()), 2 * work.lattice_step);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

TEST_P(PlaneFillTest, PassesThroughEdgesInside) {
  CellHoles work = WorkOfSheet(
      Disc(2, 5, 4), [](const Point3& p) { return p; }, 0);
  AddInnerEdge({1, 5.25, 0.5}, {3.5, 5.25, 0.5}, work);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = FillOverPlane(hole, ProjectionFrame::Upright(), With(GetParam()), {});
  ASSERT_TRUE(patch.ok());
  double highest = 0;
  for (const Point3& p : patch.new_points) highest = std::max(highest, p.z());
  EXPECT_GT(highest, 0.2) << "the surface around rises to it";
  const HolePatch filled = ToHolePatch(hole, std::move(patch));
  const RimSegment edge = work.holes[0].inner_edges[0];
  EXPECT_EQ(TrianglesAt(edge.from, edge.to, filled.triangles), 2);
  ExpectClosesHole(work, work.holes[0], filled);
}

TEST_P(PlaneFillTest, FillsAWallOverItsPlane) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const LocalPatch own =
      FillOverPlane(hole, ProjectionFrame(hole.positions[0], hole.VectorArea()), With(GetParam()), {});
  const LocalPatch facing = FillOverFacingPlane(hole, With(GetParam()));
  for (const LocalPatch& patch : {own, facing}) {
    ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, patch));
    ASSERT_FALSE(patch.new_points.empty());
    for (const Point3& p : patch.new_points) EXPECT_NEAR(p.y(), 0, work.lattice_step);
  }
}

TEST_P(PlaneFillTest, SaysThatAWallDoesNotProjectOnTheGround) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0);
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const auto fill = [&] { return FillOverPlane(hole, ProjectionFrame::Upright(), With(GetParam()), {}).failure; };
  EXPECT_EQ(fill(), FillFailure::kCrossesOnItsPlane);
  hole.open = true;
  EXPECT_EQ(fill(), FillFailure::kCrossesSeenFromAbove);
}

TEST_P(PlaneFillTest, IsFlatAtALevel) {
  CellHoles work = WorkOfSheet(
      Disc(2, 5, 4), [](const Point3& p) { return p; }, 0.2);
  work.holes[0].level = -1.5;
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const LocalPatch patch = FillOverPlane(hole, ProjectionFrame::Upright(), With(GetParam()), {});
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), -1.5);
}

TEST(PlaneFillTest, ChoosesATensionByTheWholeRimOnly) {
  const auto waves = [](const Point3& p) {
    return Point3(p.x(), p.y(), std::sin(0.4 * p.x()) + std::cos(0.5 * p.y()));
  };
  const CellHoles work = WorkOfSheet(Disc(0, 5, 9), waves, 0.02);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const FillOptions options = With(Surface::kThinPlate);
  EXPECT_TRUE(FillOverPlane(hole, ProjectionFrame::Upright(), options, {RimUse::kWhole}).hold_out.has_value());
  EXPECT_FALSE(FillOverPlane(hole, ProjectionFrame::Upright(), options, {RimUse::kPart}).hold_out.has_value());
}

}  // namespace
}  // namespace tilemend
