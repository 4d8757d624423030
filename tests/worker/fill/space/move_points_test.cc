#include "worker/fill/space/move_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::IsEmpty;
using ::testing::Lt;
using ::testing::Not;
using ::testing::SizeIs;

// A hole in flat ground under a cone, 0.1 m high.
class MovePointsTest : public testing::Test {
 protected:
  MovePointsTest() {
    patch_.new_points = {kTip};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, hole_.size()});
  }

  // Moves the tip off a needle that stands there, and returns the triangles that still cross it.
  std::vector<int32_t> MoveOff(double lowest, double highest) {
    const std::vector<SpaceTriangle> needle = {
        {Point3(0, -5, lowest), Point3(0.01, -5, lowest), Point3(0, -5, highest)}};
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), [&](const Point3&, const Point3&) { return needle; },
                        {});
    MovePoints(hole_, needle, check.Crossed(patch_), patch_);
    return check.Crossed(patch_);
  }

  static inline const Point3 kTip{0, -5, 0.1};
  const CellHoles work_ = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
};

TEST_F(MovePointsTest, MovesAPointAwayFromSurfaceThatItPassesThrough) {
  const std::vector<Triangle> before = patch_.triangles;
  EXPECT_THAT(MoveOff(0.08, 0.2), IsEmpty());
  EXPECT_EQ(patch_.triangles, before);
  EXPECT_GT((patch_.new_points[0] - kTip).head<2>().norm(), 0.1);
  EXPECT_GT(patch_.new_points[0].z(), 0) << "stays on the cone";
  EXPECT_LT(patch_.new_points[0].z(), kTip.z());
}

TEST_F(MovePointsTest, GoesWhereFewerTrianglesCross) {
  const size_t all = patch_.triangles.size();
  EXPECT_THAT(MoveOff(-9, 9), AllOf(Not(IsEmpty()), SizeIs(Lt(all))));
}

TEST_F(MovePointsTest, DoesNotMoveTheTopOfAHill) {
  patch_.new_points[0].z() = 1;
  EXPECT_THAT(MoveOff(0.9, 1.1), Not(IsEmpty()));
  EXPECT_EQ(patch_.new_points[0], Point3(0, -5, 1));
}

TEST_F(MovePointsTest, LeavesAPatchThatCrossesNothing) {
  EXPECT_THAT(MoveOff(4, 6), IsEmpty());
  EXPECT_EQ(patch_.new_points, std::vector<Point3>{kTip});
}

}  // namespace
}  // namespace tilemend
