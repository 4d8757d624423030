#include "worker/fill/plane/folded_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/fill/plane/plane_fill.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

LocalPatch Filled(const LocalHole& hole, Surface surface) {
  const SurfaceNear near;
  CrossingCheck check(hole, ReachOf(*hole.cell, hole.cell->holes[0]), near, {});
  return FillFolded(hole, ProjectionFrame::Upright(), With(surface), check);
}

class FoldedFillTest : public testing::TestWithParam<Surface> {};
INSTANTIATE_TEST_SUITE_P(Surfaces, FoldedFillTest, testing::Values(Surface::kWang, Surface::kThinPlate));

TEST_P(FoldedFillTest, FillsASimpleHoleAsItIs) {
  const CellHoles work = WorkOfSheet(
      Disc(2, 5, 4), [](const Point3& p) { return p; }, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  for (const Point3& p : patch.new_points) EXPECT_NEAR(p.z(), 0, 2 * work.lattice_step);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

TEST_P(FoldedFillTest, ClosesAWallThatHasNoRegionOnTheGround) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

// A step of a wall in the rim: seen from above two of its vertices are nearly one.
Point3 LeanAtStep(const Point3& p) {
  const bool step = p.x() > 1 && p.y() == 2;
  return step ? Point3(p.x(), 3.2, 1) : p;
}

TEST_P(FoldedFillTest, TakesSmallFoldsForWhatTheyAre) {
  const CellHoles work = WorkOfSheet(Disc(2, 5, 3), LeanAtStep, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const bool goes_around_edges = GetParam() == Surface::kWang;
  EXPECT_EQ(FillOverPlane(hole, ProjectionFrame::Upright(), With(GetParam()), {}).ok(), goes_around_edges);
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

TEST_P(FoldedFillTest, HasNewVerticesOfWaterAtItsLevel) {
  CellHoles work = WorkOfSheet(Disc(2, 5, 3), LeanAtStep, 0);
  work.holes[0].level = -0.5;
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_EQ(p.z(), -0.5);
}

// One edge in the region, one in the fold that is cut off.
TEST_P(FoldedFillTest, PassesThroughEdgesInsideTheRegion) {
  CellHoles work = WorkOfSheet(Disc(2, 5, 3), LeanAtStep, 0);
  AddInnerEdge({1.25, 5.25, 0.5}, {2.5, 5.25, 0.5}, work);
  AddInnerEdge({2.25, 2.25, 0.5}, {2.75, 2.25, 0.5}, work);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  const HolePatch filled = ToHolePatch(hole, std::move(patch));
  const RimSegment in = work.holes[0].inner_edges[0], out = work.holes[0].inner_edges[1];
  EXPECT_EQ(TrianglesAt(in.from, in.to, filled.triangles), 2);
  EXPECT_EQ(TrianglesAt(out.from, out.to, filled.triangles), 0);
  ExpectClosesHole(work, work.holes[0], filled);
}

// From the region, over its boundary, into the fold that is cut off.
TEST_P(FoldedFillTest, LeavesOutEdgesThatTheFoldCuts) {
  CellHoles work = WorkOfSheet(Disc(2, 5, 3), LeanAtStep, 0);
  AddInnerEdge({1.25, 5.25, 0.5}, {2.5, 5.25, 0.5}, work);
  AddInnerEdge({2.25, 4.5, 0.5}, {2.25, 2.25, 0.5}, work);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok());
  const HolePatch filled = ToHolePatch(hole, std::move(patch));
  const RimSegment in = work.holes[0].inner_edges[0], cut = work.holes[0].inner_edges[1];
  EXPECT_EQ(TrianglesAt(in.from, in.to, filled.triangles), 2);
  EXPECT_EQ(TrianglesAt(cut.from, cut.to, filled.triangles), 0);
  ExpectClosesHole(work, work.holes[0], filled);
}

// A hole over the foot of a wall, the wall and its roof, as lakes beside houses have them: from any place and size.
TEST_P(FoldedFillTest, ClosesWhateverFoldsTheBoundaryHas) {
  const auto uneven = [](const Point3& p) {
    const double off = 0.05 * std::sin(17 * p.x() + 29 * p.y());
    return Point3(FoldToBuilding(p) + Point3(off, -off, 0.7 * off));
  };
  for (const double along : {-1.0, 0.0, 2.5}) {
    for (const double radius : {3.0, 4.5, 6.0}) {
      const CellHoles work = WorkOfSheet(Disc(along, kWallHeight / 3, radius), uneven, 0);
      const CellBand band(work);
      LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
      hole.open = true;
      LocalPatch patch = Filled(hole, GetParam());
      ASSERT_TRUE(patch.ok()) << along << ", " << radius;
      ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
    }
  }
}

// Four strips of surface in a hole cross like a #. The square that they enclose, smaller than their edges, has none of
// their vertices, but there is a piece of surface inside.
TEST_P(FoldedFillTest, FillsAroundAnIslandBetweenCrossings) {
  const auto in = [](const Point3& p, double u, double v, double width, double height) {
    return p.x() >= u && p.x() <= u + width && p.y() >= v && p.y() <= v + height;
  };
  const auto is_left = [=](const Point3& p) { return in(p, -4, -3, 1, 16); };
  const auto is_right = [=](const Point3& p) { return in(p, 4, -3, 1, 16); };
  const auto is_lower = [=](const Point3& p) { return in(p, -8, -7, 16, 1); };
  const auto is_upper = [=](const Point3& p) { return in(p, -8, 16, 16, 1); };
  const auto is_island = [=](const Point3& p) { return in(p, 10, 5, 1, 1); };
  const auto hole_of = [=](double u, double v) {
    const Point3 p(u, v, 0);
    return in(p, -14, -9, 28, 28) && !is_left(p) && !is_right(p) && !is_lower(p) && !is_upper(p) && !is_island(p);
  };
  const auto cross = [=](const Point3& p) {
    if (is_left(p)) return Point3(p + Point3(3.2, 0, 0));
    if (is_right(p)) return Point3(p - Point3(3.2, 0, 0));
    if (is_lower(p)) return Point3(p + Point3(0, 6.2, 1));
    if (is_upper(p)) return Point3(p + Point3(0, -15.2, 1));
    if (is_island(p)) return Point3(0.35 + 0.3 * (p.x() - 10), 0.35 + 0.3 * (p.y() - 5), 0);
    return p;
  };
  const CellHoles work = WorkOfSheet(hole_of, cross, 0);
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  hole.open = true;
  LocalPatch patch = Filled(hole, GetParam());
  ASSERT_TRUE(patch.ok()) << TextOf(patch.failure, {});
  EXPECT_EQ(FaultOf(hole, patch), FillFailure::kNone);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

// Of seams and feet of walls no surface tells that the edges are there: the region's part knows the boundary's edges
// that it goes around, and has none of them again.
TEST_P(FoldedFillTest, HasNoEdgeOfTheBoundaryTwice) {
  for (const double along : {-1.0, 0.0, 1.0, 2.5, 4.0}) {
    for (const double radius : {3.0, 3.5, 4.5, 5.0, 6.0, 7.0}) {
      for (const double step : {0.02, 0.05, 0.1, 0.2}) {
        const auto uneven = [=](const Point3& p) {
          const double off = step * std::sin(17 * p.x() + 29 * p.y());
          return Point3(FoldToBuilding(p) + Point3(off, -off, 0.7 * off));
        };
        CellHoles work = WorkOfSheet(Disc(along, kWallHeight / 3, radius), uneven, 0);
        work.band.triangles.clear();
        const CellBand band(work);
        LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
        hole.open = true;
        LocalPatch patch = Filled(hole, GetParam());
        ASSERT_TRUE(patch.ok()) << along << ", " << radius;
        EXPECT_EQ(FaultOf(hole, patch), FillFailure::kNone) << along << ", " << radius << ", " << step;
      }
    }
  }
}

}  // namespace
}  // namespace tilemend
