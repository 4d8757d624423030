#include "worker/papers/wang/least_area_fill.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

TEST(LeastAreaFillTest, ClosesAHoleAcrossACorner) {
  const CellHoles work = WorkOfSheet(Disc(0, 0, 4), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const LocalPatch patch = FillLeastArea(hole, {});
  EXPECT_FALSE(patch.new_points.empty());
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, patch));
}

TEST(LeastAreaFillTest, TiesAnIslandToTheRest) {
  const auto ring = [](double u, double v) { return std::hypot(u, v + 5) > 1 && std::hypot(u, v + 5) < 4; };
  const CellHoles work = WorkOfSheet(ring, FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.loops.size(), 2u);
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, FillLeastArea(hole, {})));
}

TEST(LeastAreaFillTest, RefusesALongBoundary) {
  const CellHoles work = WorkOfSheet(Disc(0, 0, 4), FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  FillOptions options;
  options.wang.longest_loop = hole.size() - 1;
  EXPECT_EQ(FillLeastArea(hole, options).failure, FillFailure::kTooLongForArea);
}

}  // namespace
}  // namespace tilemend
