#include "worker/fill/space/patch_soundness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;

// A hole of one unit square in flat ground, closed by two triangles.
class PatchSoundnessTest : public testing::Test {
 protected:
  PatchSoundnessTest() {
    const std::vector<int32_t>& loop = hole_.loops[0].vertices;
    patch_.triangles = {{loop[0], loop[1], loop[2]}, {loop[0], loop[2], loop[3]}};
  }

  bool Crosses(std::vector<SpaceTriangle> surface, bool* rim_is_crossed = nullptr) {
    const SurfaceNear near = [&](const Point3&, const Point3&) { return surface; };
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
    const bool crosses = check.Crosses(patch_);
    if (rim_is_crossed != nullptr) *rim_is_crossed = check.rim_is_crossed();
    return crosses;
  }

  // A needle across the ground at (x, y).
  static SpaceTriangle Across(double x, double y) {
    return {Point3(x, y, -1), Point3(x + 0.01, y, -1), Point3(x, y, 1)};
  }

  const CellHoles work_ = WorkOfSheet(Disc(0.5, -4.5, 0.6), FoldToBuilding, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
};

TEST_F(PatchSoundnessTest, FindsNoFaultWithASoundPatch) {
  ASSERT_EQ(hole_.size(), 4);
  EXPECT_EQ(FaultOf(hole_, patch_), FillFailure::kNone);
  EXPECT_FALSE(FacesDown(hole_, patch_, ProjectionFrame::Upright()));
  EXPECT_FALSE(Crosses({}));
}

TEST_F(PatchSoundnessTest, NamesTheFault) {
  LocalPatch open = patch_;
  open.triangles.pop_back();
  EXPECT_EQ(FaultOf(hole_, open), FillFailure::kNotClosed);
  LocalPatch twice = patch_;
  twice.triangles.push_back(twice.triangles[0]);
  EXPECT_EQ(FaultOf(hole_, twice), FillFailure::kOverfullEdge);
  LocalPatch flat = patch_;
  flat.new_points = {hole_.positions[0]};
  flat.triangles.push_back({0, 1, hole_.size()});
  EXPECT_EQ(FaultOf(hole_, flat), FillFailure::kFlatTriangle);
}

TEST_F(PatchSoundnessTest, SeesWhatFacesDown) {
  for (Triangle& t : patch_.triangles) std::swap(t[1], t[2]);
  EXPECT_TRUE(FacesDown(hole_, patch_, ProjectionFrame::Upright()));
}

TEST_F(PatchSoundnessTest, SeesWhatPassesThroughThePatch) {
  EXPECT_TRUE(Crosses({Across(0.4, -4.3)}));
  EXPECT_FALSE(Crosses({Across(3.4, -4.3)}));
}

TEST_F(PatchSoundnessTest, DoesNotCountWhatPassesThroughTheRim) {
  bool rim_is_crossed = false;
  const SpaceTriangle through_rim = {Point3(0.3, -6, -1), Point3(0.3, -3, -1), Point3(0.3, -4.5, 1)};
  EXPECT_FALSE(Crosses({through_rim}, &rim_is_crossed));
  EXPECT_TRUE(rim_is_crossed);
  EXPECT_TRUE(Crosses({through_rim, Across(0.4, -4.3)}, &rim_is_crossed));
}

// In what is written it and the surface's own vertex would be one.
TEST_F(PatchSoundnessTest, CountsANewPointThatTheSurfaceHas) {
  const std::vector<int32_t> loop = hole_.loops[0].vertices;
  const int32_t middle = hole_.size();
  const Point3 place = (hole_.positions[loop[0]] + hole_.positions[loop[2]]) / 2;
  patch_.new_points = {place};
  patch_.triangles.clear();
  for (int32_t i = 0; i < 4; ++i) patch_.triangles.push_back({loop[i], loop[(i + 1) % 4], middle});
  const auto hanging = [](const Point3& tip) {
    return SpaceTriangle{tip, tip + Point3(0.1, 0, -1), tip + Point3(0, 0.1, -1)};
  };
  EXPECT_FALSE(Crosses({hanging(place - Point3(0, 0, 0.01))}));
  EXPECT_TRUE(Crosses({hanging(place)}));
  const SurfaceNear near = [&](const Point3&, const Point3&) { return std::vector<SpaceTriangle>{hanging(place)}; };
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
  EXPECT_EQ(check.Crossed(patch_), (std::vector<int32_t>{0, 1, 2, 3}));
}

TEST_F(PatchSoundnessTest, CountsNewPointsAtOnePlace) {
  patch_.new_points = {Point3(0, 0, 5), Point3(1, 0, 5)};
  EXPECT_FALSE(Crosses({}));
  patch_.new_points = {Point3(0, 0, 5), Point3(0, 0, 5)};
  EXPECT_TRUE(Crosses({}));
  patch_.new_points = {hole_.positions[1]};
  EXPECT_TRUE(Crosses({}));
}

TEST_F(PatchSoundnessTest, CountsPatchesMadeBefore) {
  HolePatch earlier;
  earlier.new_points = {Point3(0.4, -4.3, -1), Point3(0.41, -4.3, -1), Point3(0.4, -4.3, 1)};
  earlier.triangles = {{-1, -2, -3}};
  const SurfaceNear none = [](const Point3&, const Point3&) { return std::vector<SpaceTriangle>(); };
  std::vector<HolePatch> patches;
  EarlierPatches before(work_, patches);
  // Some that lie elsewhere: the one is found among them, whatever their number.
  for (int k = 0; k < 6; ++k) {
    patches.push_back(k == 2 ? earlier : HolePatch());
    if (k > 2) patches.back() = {.new_points = std::vector<Point3>(3, Point3(90, 90, k)), .triangles = {{-1, -2, -3}}};
    before.TakeLast();
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), none, &before);
    EXPECT_EQ(check.Crosses(patch_), k >= 2) << k;
  }
}

// It passes through the hole's boundary and the surface beside it. If it is of the input, every patch is crossed.
TEST_F(PatchSoundnessTest, PatchesMadeBeforeNeedNotBeCrossed) {
  const SpaceTriangle blade = {Point3(0.3, -6, -1), Point3(0.3, -3, -1), Point3(0.3, -4.5, 1)};
  std::vector<SpaceTriangle> surface;
  const std::vector<Point3>& points = work_.band.points;
  for (const Triangle& t : work_.band.triangles) surface.push_back({points[t[0]], points[t[1]], points[t[2]]});
  const SurfaceNear near = [&](const Point3&, const Point3&) { return surface; };
  std::vector<HolePatch> patches = {{.new_points = {blade[0], blade[1], blade[2]}, .triangles = {{-1, -2, -3}}}};
  EarlierPatches before(work_, patches);
  before.TakeLast();
  CrossingCheck after_it(hole_, ReachOf(work_, work_.holes[0]), near, &before);
  EXPECT_THAT(after_it.CrossedAvoidably(patch_), Not(IsEmpty()));
  surface.push_back(blade);
  CrossingCheck with_it(hole_, ReachOf(work_, work_.holes[0]), near, {});
  EXPECT_THAT(with_it.CrossedAvoidably(patch_), IsEmpty());
}

TEST_F(PatchSoundnessTest, KnowsHowFarAPatchMayGo) {
  const CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), {}, {});
  patch_.new_points = {Point3(0.5, -4.5, 0.5)};
  EXPECT_TRUE(check.StaysNear(patch_));
  patch_.new_points = {Point3(0.5, -4.5, 5)};
  EXPECT_FALSE(check.StaysNear(patch_));
}

}  // namespace
}  // namespace tilemend
