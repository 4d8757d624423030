#include "worker/fill/space/crossing_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A strip of triangles in the plane z = 0 along x, from 0 to 4, and a fence across it at y = 0.5 of two triangles.
// Their common edge passes through triangle 2 of the strip.
class CrossingCurvesTest : public ::testing::Test {
 protected:
  std::vector<bool> Continue(const std::vector<bool>& is_added, const std::vector<CrossingPair>& pairs) const {
    return ContinueCrossings(points_, triangles_, is_added, pairs);
  }

  const std::vector<Point3> points_ = {{0, 0, 0}, {0, 1, 0},      {2, 0, 0},     {2, 1, 0},     {4, 0, 0},
                                       {4, 1, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {2.5, 0.5, 1}, {3.5, 0.5, -1}};
  const std::vector<Triangle> triangles_ = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {6, 8, 7}, {6, 9, 8}};
  const std::vector<CrossingPair> all_ = {{0, 4}, {1, 4}, {1, 5}, {2, 5}};
};

TEST_F(CrossingCurvesTest, FollowsACurveOverTheEdgesOfBothSurfaces) {
  // All of the strip but its beginning is new, and the second half of the fence.
  EXPECT_THAT(Continue({false, true, true, true, false, true}, {all_[1], all_[2], all_[3]}), Each(true));
}

TEST_F(CrossingCurvesTest, ACurveBetweenNewTrianglesEndsAtTheInputIfThatDoesNotCross) {
  // The part of the fence that crosses the old part of the strip is new as well.
  EXPECT_THAT(Continue({false, true, true, true, true, true}, all_), Each(false));
}

TEST_F(CrossingCurvesTest, CurvesApartAreToldApart) {
  // The fence's middle is no crossing of this list, so that its two ends are curves of their own.
  EXPECT_THAT(Continue({false, true, true, true, false, true}, {all_[1], all_[3]}), ElementsAre(true, false));
}

TEST_F(CrossingCurvesTest, NamesTheTrianglesThatNeedNotCross) {
  const auto at = [&](int t) -> SpaceTriangle {
    return {points_[triangles_[t][0]], points_[triangles_[t][1]], points_[triangles_[t][2]]};
  };
  const std::vector<SpaceTriangle> fence = {at(4), at(5)}, strip = {at(0), at(1), at(2), at(3)};
  EXPECT_THAT(AvoidableCrossings(fence, strip), ElementsAre(0, 1));
  // Now the strip's beginning and the fence's are of the surface, and cross there.
  const std::vector<SpaceTriangle> patch = {at(5), at(2), at(3)}, surface = {at(0), at(1), at(4)};
  EXPECT_THAT(AvoidableCrossings(patch, surface), IsEmpty());
  // Where the fence's beginning is of an earlier patch, the curve comes to nothing that crossed before. Where the
  // fence's end is, it goes on along that.
  EXPECT_THAT(AvoidableCrossings(patch, std::vector{at(0), at(1)}, std::vector{at(4)}), Contains(0));
  const std::vector<SpaceTriangle> end = {at(3)}, rest = {at(0), at(1), at(2), at(4)}, fence_end = {at(5)};
  EXPECT_THAT(CrossedTriangles(end, fence_end), SizeIs(1));
  EXPECT_THAT(AvoidableCrossings(end, rest, fence_end), IsEmpty());
  const std::vector<SpaceTriangle> alone = {at(5)}, flat = {at(1), at(2)};
  EXPECT_THAT(AvoidableCrossings(alone, flat), ElementsAre(0));
}

}  // namespace
}  // namespace tilemend
