#include "worker/fill/space/unrolled_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

constexpr double kRadius = 5;

// Three quarters of the way round a tank: over no plane.
CellHoles AroundATank() { return WorkOfSheet(IsInTankSlit, RollRoundTank(kRadius), 0); }

TEST(UnrolledFillTest, FollowsATank) {
  const CellHoles work = AroundATank();
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  FreeAtFolds(hole);
  LocalPatch patch = FillUnrolled(hole, {});
  ASSERT_TRUE(patch.ok());
  ASSERT_GT(patch.new_points.size(), 30u);
  for (const Point3& p : patch.new_points) EXPECT_NEAR(std::hypot(p.y(), p.z()), kRadius, 0.3);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(patch)));
}

TEST(UnrolledFillTest, KeepsToTheTrianglesWithoutBending) {
  const CellHoles work = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  std::vector<Triangle> fan;
  const std::vector<int32_t>& loop = hole.loops[0].vertices;
  for (size_t i = 1; i + 1 < loop.size(); ++i) fan.push_back({loop[0], loop[i], loop[i + 1]});
  hole.positions[loop[5]].z() += 2;  // off the ground: the fan has a ridge there
  const LocalPatch bare = FillOver(fan, 0, hole, {}), bent = FillOver(fan, 1, hole, {});
  ASSERT_TRUE(bare.ok() && bent.ok());
  EXPECT_EQ(bare.triangles, bent.triangles);
  EXPECT_NE(bare.new_points, bent.new_points);
}

TEST(UnrolledFillTest, DoesNotApplyToIslands) {
  const auto ring = [](double u, double v) { return std::hypot(u, v + 5) > 1 && std::hypot(u, v + 5) < 4; };
  const CellHoles work = WorkOfSheet(ring, FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.loops.size(), 2u);
  EXPECT_EQ(FillUnrolled(hole, {}).failure, FillFailure::kNotApplicable);
  EXPECT_EQ(FillOver({}, 1, hole, {}).failure, FillFailure::kNotApplicable);
}

}  // namespace
}  // namespace tilemend
