#include "worker/fill/crease/part_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

LocalPatch FillAsPart(const CellHoles& work) {
  const CellBand band(work);
  LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  FreeAtFolds(hole);
  FillOptions options;
  options.surface = Surface::kThinPlate;
  LocalPatch patch = FillPart(hole, options);
  if (patch.ok()) ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, patch));
  return patch;
}

TEST(PartFillTest, FillsAWallOverItsPlane) {
  const LocalPatch patch = FillAsPart(WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0));
  ASSERT_TRUE(patch.ok());
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_NEAR(p.y(), 0, 0.001);
}

TEST(PartFillTest, UnrollsWhatIsSteep) {
  const LocalPatch patch = FillAsPart(WorkOfSheet(IsInTankSlit, RollRoundTank(5), 0));
  ASSERT_TRUE(patch.ok());
  ASSERT_FALSE(patch.new_points.empty());
  for (const Point3& p : patch.new_points) EXPECT_NEAR(std::hypot(p.y(), p.z()), 5, 0.3);
}

}  // namespace
}  // namespace tilemend
