#include "worker/fill/space/mend_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A hole in flat ground, closed by a fan about one point.
class MendCrossingsTest : public testing::Test {
 protected:
  void CloseAbout(const Point3& tip) {
    patch_.new_points = {tip};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, hole_.size()});
  }

  // The patch when it is mended, in ground with such a surface in the hole.
  LocalPatch Mended(const std::vector<SpaceTriangle>& surface = {}) {
    const SurfaceNear near = [&](const Point3&, const Point3&) { return surface; };
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
    LocalPatch mended = MendCrossings(hole_, patch_, check);
    crossed_ = check.Crossed(mended);
    return mended;
  }

  // A needle that stands across the ground at (x, y).
  static SpaceTriangle Across(double x, double y) {
    return {Point3(x, y, -0.3), Point3(x + 0.01, y, -0.3), Point3(x, y, 0.3)};
  }

  const CellHoles work_ = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band_{work_};
  LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
  std::vector<int32_t> crossed_;
};

TEST_F(MendCrossingsTest, LeavesASoundPatchAsItIs) {
  CloseAbout({0, -5, 0.5});
  const LocalPatch mended = Mended();
  EXPECT_EQ(mended.new_points, patch_.new_points);
  EXPECT_EQ(mended.triangles, patch_.triangles);
}

TEST_F(MendCrossingsTest, ClosesAnewWhereAPatchPassesThroughItself) {
  CloseAbout({9, -5, 0});
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), {}, {});
  ASSERT_TRUE(check.Crosses(patch_));
  LocalPatch mended = Mended();
  EXPECT_THAT(crossed_, IsEmpty());
  EXPECT_THAT(mended.new_points, IsEmpty()) << "no triangle needs it any more";
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(mended)));
}

TEST_F(MendCrossingsTest, GoesAroundSurfaceInTheHole) {
  CloseAbout({0, -5, 0});
  LocalPatch mended = Mended({Across(0.6, -4.8)});
  EXPECT_THAT(crossed_, IsEmpty());
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(mended)));
}

TEST_F(MendCrossingsTest, KeepsWaterAtItsLevel) {
  CloseAbout({0, -5, 0});
  hole_.level = 0;
  const LocalPatch mended = Mended({Across(0.6, -4.8)});
  EXPECT_THAT(crossed_, Not(IsEmpty())) << "flat, it can only be crossed";
  for (const Point3& p : mended.new_points) EXPECT_EQ(p.z(), 0);
}

TEST_F(MendCrossingsTest, DropsWhatClosesNothing) {
  CloseAbout({0, -5, 0});
  const size_t sound = patch_.triangles.size();
  const int32_t first = hole_.size() + 1;  // a triangle and its back
  patch_.new_points.insert(patch_.new_points.end(), {{5, -5, 1}, {6, -5, 1}, {5, -6, 1}});
  patch_.triangles.insert(patch_.triangles.end(), {{first, first + 1, first + 2}, {first + 2, first + 1, first}});
  const LocalPatch mended = Mended();
  EXPECT_THAT(mended.triangles, SizeIs(sound));
  EXPECT_THAT(mended.new_points, SizeIs(1));
}

// A hill of the patch: what faces up stays near where it was, or it is left as it is.
TEST_F(MendCrossingsTest, DoesNotMoveTheGround) {
  const Point3 top(0, -5, 1);
  CloseAbout(top);
  const LocalPatch mended = Mended({{Point3(0.6, -4.8, 0.4), Point3(0.61, -4.8, 0.4), Point3(0.6, -4.8, 0.9)}});
  EXPECT_THAT(mended.new_points, Contains(top));
}

}  // namespace
}  // namespace tilemend
