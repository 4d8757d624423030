#include "worker/fill/space/faired_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/fill/space/space_fill.h"

namespace tilemend {
namespace {

constexpr double kRadius = 5;

// A hole three quarters of the way round a tank.
class FairedFillTest : public testing::Test {
 protected:
  FairedFillTest() : work_(WorkOfSheet(IsInTankSlit, RollRoundTank(kRadius), 0)), band_(work_) {
    hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
    FreeAtFolds(hole_);
    triangles_ = TriangulateInSpace(hole_, hole_.loops[0].vertices, {}, CrossingIndex({}));
  }

  LocalPatch Fill(const SurfaceNear& near) {
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
    return FillFaired(triangles_, hole_, {}, check);
  }

  const CellHoles work_;
  const CellBand band_;
  LocalHole hole_;
  std::vector<Triangle> triangles_;
};

TEST_F(FairedFillTest, FollowsATank) {
  LocalPatch patch = Fill({});
  ASSERT_TRUE(patch.ok());
  ASSERT_GT(patch.new_points.size(), 20u);
  for (const Point3& p : patch.new_points) EXPECT_NEAR(std::hypot(p.y(), p.z()), kRadius, 0.5);
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(patch)));
}

// The triangle touches the patch: there the patch keeps off, elsewhere it bends as before.
TEST_F(FairedFillTest, IsTakenBackWhereItCrosses) {
  const LocalPatch free = Fill({});
  ASSERT_TRUE(free.ok());
  double most = 0;
  for (const Point3& p : free.new_points) most = std::max(most, std::hypot(p.y(), p.z()));
  const auto furthest = std::find_if(free.new_points.begin(), free.new_points.end(),
                                     [&](const Point3& p) { return std::hypot(p.y(), p.z()) == most; });
  const Point3 tip = *furthest;
  const Point3 out = Point3(0, tip.y(), tip.z()).normalized();
  const SpaceTriangle thorn = {tip - 1e-3 * out, tip + Point3(0.01, 0, 0) + out, tip - Point3(0.01, 0, 0) + out};
  const SurfaceNear near = [&](const Point3&, const Point3&) { return std::vector<SpaceTriangle>{thorn}; };
  const LocalPatch patch = Fill(near);
  ASSERT_TRUE(patch.ok());
  ASSERT_EQ(patch.triangles, free.triangles);
  size_t same = 0;
  for (size_t k = 0; k < patch.new_points.size(); ++k) same += patch.new_points[k] == free.new_points[k];
  EXPECT_LT(same, patch.new_points.size());
  EXPECT_GT(same, 0u);
}

}  // namespace
}  // namespace tilemend
