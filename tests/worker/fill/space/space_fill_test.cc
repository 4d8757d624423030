#include "worker/fill/space/space_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

LocalPatch FillInSpace(const CellHoles& work, const LocalHole& hole, Surface surface = Surface::kThinPlate) {
  FillOptions options;
  options.surface = surface;
  options.published = AllPublishedWays();
  const SurfaceNear none;
  CrossingCheck check(hole, ReachOf(work, work.holes[0]), none, {});
  return FillInSpace(hole, options, check);
}

TEST(SpaceFillTest, ClosesAHoleInAWall) {
  const CellHoles work = WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const LocalPatch refined = FillInSpace(work, hole), wang = FillInSpace(work, hole, Surface::kWang);
  for (const LocalPatch& patch : {refined, wang}) {
    ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, patch));
    EXPECT_FALSE(patch.new_points.empty());
    for (const Point3& p : patch.new_points) EXPECT_NEAR(p.y(), 0, 1e-3);
  }
}

TEST(SpaceFillTest, TiesAnIslandToTheRest) {
  const auto ring = [](double u, double v) { return std::hypot(u, v + 5) > 1 && std::hypot(u, v + 5) < 4; };
  const CellHoles work = WorkOfSheet(ring, FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.loops.size(), 2u);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, FillInSpace(work, hole)));
}

TEST(SpaceFillTest, RefusesALongBoundary) {
  const CellHoles work = WorkOfSheet(
      Disc(0, 5, 3), [](const Point3& p) { return p; }, 0);
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  hole.segments.resize(kLongestSpatialLoop + 1, hole.segments[0]);
  EXPECT_EQ(FillInSpace(work, hole).failure, FillFailure::kTooLongForSpace);
}

TEST(SpaceFillTest, MakesNoUsedEdge) {
  const CellHoles work = WorkOfSheet(Disc(0.5, -4.5, 0.6), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.size(), 4);
  const std::vector<int32_t>& loop = hole.loops[0].vertices;
  for (const int first : {0, 1}) {
    const VertexPair diagonal = Undirected(loop[first], loop[first + 2]);
    const std::vector<Triangle> triangles = TriangulateInSpace(hole, loop, {diagonal}, CrossingIndex({}));
    ASSERT_EQ(triangles.size(), 2u);
    for (const Triangle& t : triangles) {
      EXPECT_FALSE(std::count(t.begin(), t.end(), diagonal.first) && std::count(t.begin(), t.end(), diagonal.second));
    }
  }
  EXPECT_TRUE(
      TriangulateInSpace(hole, loop, {Undirected(loop[0], loop[2]), Undirected(loop[1], loop[3])}, CrossingIndex({}))
          .empty());
}

}  // namespace
}  // namespace tilemend
