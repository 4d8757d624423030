#include "worker/fill/space/patch_creases.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

// A disc in a flat sheet, closed by a cone.
class PatchCreasesTest : public testing::Test {
 protected:
  LocalPatch ConeTo(const Point3& tip) const {
    LocalPatch patch;
    patch.new_points = {tip};
    const std::vector<int32_t>& loop = hole_.loops[0].vertices;
    for (size_t i = 0; i < loop.size(); ++i) {
      patch.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], hole_.size()});
    }
    return patch;
  }

  Point3 Middle() const {
    Point3 middle = Point3::Zero();
    for (const Point3& p : hole_.positions) middle += p / hole_.size();
    return middle;
  }

  // Past the rim and a little above the sheet: the cone lies back on it there.
  Point3 Beyond() const { return Middle() + 1.2 * (hole_.positions[0] - Middle()) + Point3(0, 0, 0.3); }

  const CellHoles work_ = WorkOfSheet(
      Disc(0, 5, 3), [](const Point3& p) { return p; }, 0);
  const SurfaceNear band_alone_;
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

TEST_F(PatchCreasesTest, CountsWhereAPatchFoldsBack) {
  EXPECT_EQ(CountCreases(hole_, ConeTo(Middle())), 0);
  EXPECT_GT(CountCreases(hole_, ConeTo(Beyond())), 0);
}

TEST_F(PatchCreasesTest, CountsSpikes) {
  EXPECT_EQ(CountSpikes(hole_, ConeTo(Middle())), 0);
  EXPECT_EQ(CountSpikes(hole_, ConeTo(Middle() + Point3(0, 0, 30))), 1);
}

TEST_F(PatchCreasesTest, MeasuresTheTurnAtTheRim) {
  EXPECT_NEAR(TurnAtRim(hole_, ConeTo(Middle())), 0, 1e-12);
  // A steep cone stands on the sheet nearly upright.
  EXPECT_NEAR(TurnAtRim(hole_, ConeTo(Middle() + Point3(0, 0, 1000))), std::numbers::pi / 2, 0.01);
}

TEST_F(PatchCreasesTest, BevelsThem) {
  const LocalPatch folded = ConeTo(Beyond());
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), band_alone_, {});
  ASSERT_TRUE(check.IsSound(folded));
  const LocalPatch bevelled = BevelCreases(hole_, folded, check);
  EXPECT_TRUE(check.IsSound(bevelled));
  EXPECT_LT(CountCreases(hole_, bevelled), CountCreases(hole_, folded));
  EXPECT_EQ(bevelled.new_points[0], folded.new_points[0]);
}

TEST_F(PatchCreasesTest, KeepsABevelOnlyWhereItCrossesNothing) {
  const LocalPatch folded = ConeTo(Beyond());
  const LocalPatch free = [&] {
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), band_alone_, {});
    return BevelCreases(hole_, folded, check);
  }();
  ASSERT_GT(free.new_points.size(), 1U);
  std::vector<SpaceTriangle> needles;
  for (size_t k = 1; k < free.new_points.size(); ++k) {
    const Point3 out = free.new_points[k] - 1e-3 * (free.new_points[k] - free.new_points[0]);
    needles.push_back({out - Point3(0, 0, 1e-3), out + Point3(1e-4, 0, 0), out + Point3(0, 1e-4, 1e-3)});
  }
  const SurfaceNear near = [&](const Point3&, const Point3&) { return needles; };
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
  ASSERT_TRUE(check.IsSound(folded));
  EXPECT_TRUE(check.IsSound(BevelCreases(hole_, folded, check)));
}

TEST_F(PatchCreasesTest, LeavesAPatchWithoutCreasesAsItIs) {
  const LocalPatch flat = ConeTo(Middle());
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), band_alone_, {});
  EXPECT_EQ(BevelCreases(hole_, flat, check).triangles, flat.triangles);
}

}  // namespace
}  // namespace tilemend
