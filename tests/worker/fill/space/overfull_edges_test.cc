#include "worker/fill/space/overfull_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/folded_meshes.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// A hole of one unit square in flat ground.
CellHoles Square() { return WorkOfSheet(Disc(0.5, -4.5, 0.6), FoldToBuilding, 0); }

// Two triangles with a diagonal.
LocalPatch Halves(const LocalHole& hole) {
  const std::vector<int32_t>& loop = hole.loops[0].vertices;
  LocalPatch patch;
  patch.triangles = {{loop[0], loop[1], loop[2]}, {loop[0], loop[2], loop[3]}};
  return patch;
}

TEST(DivideOverfullEdgesTest, APatchBesideNoOtherSurfaceStaysAsItIs) {
  const CellHoles work = Square();
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch = Halves(hole);
  DivideOverfullEdges(hole, patch);
  EXPECT_EQ(patch.triangles, Halves(hole).triangles);
  EXPECT_THAT(patch.new_points, IsEmpty());
}

TEST(DivideOverfullEdgesTest, AnEdgeUnderAWallIsDivided) {
  CellHoles work = Square();
  LocalPatch patch;
  {
    const CellBand band(work);
    const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
    patch = Halves(hole);
    const int32_t from = hole.vertices[patch.triangles[0][0]], to = hole.vertices[patch.triangles[0][2]];
    const auto top = static_cast<int32_t>(work.band.points.size());
    const Point3 middle = (work.band.points[from] + work.band.points[to]) / 2;
    work.band.points.push_back(middle + Point3(0, 0, 3));
    work.band.points.push_back(middle + Point3(0.1, 0, 3));
    work.band.triangles.push_back({from, to, top});
    work.band.triangles.push_back({to, from, top + 1});
  }
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  EXPECT_EQ(FaultOf(hole, patch), FillFailure::kOverfullEdge);
  DivideOverfullEdges(hole, patch);
  EXPECT_EQ(FaultOf(hole, patch), FillFailure::kNone);
  EXPECT_THAT(patch.triangles, SizeIs(4));
  ASSERT_THAT(patch.new_points, SizeIs(1));
  const std::vector<int32_t>& loop = hole.loops[0].vertices;
  EXPECT_EQ(patch.new_points[0], Point3((hole.positions[loop[0]] + hole.positions[loop[2]]) / 2));
}

}  // namespace
}  // namespace tilemend
