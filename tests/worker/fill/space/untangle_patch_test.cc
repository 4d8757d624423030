#include "worker/fill/space/untangle_patch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>
#include <vector>

#include "common/mesh/triangle_shape.h"
#include "tests/support/folded_meshes.h"
#include "tests/support/outline_hole.h"
#include "worker/fill/space/minimum_weight.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Truly;

// A hole in flat ground, closed by triangles between vertices of its rim, or about a point.
class UntanglePatchTest : public testing::Test {
 protected:
  void CloseWithoutPoints() {
    std::map<int32_t, int32_t> next;
    for (const RegionSegment& s : hole_.segments) next[s.from] = s.to;
    std::vector<int32_t> loop;
    for (int32_t v = 0; loop.size() < next.size(); v = next.at(v)) loop.push_back(v);
    std::vector<Point3> places;
    for (const int32_t v : loop) places.push_back(hole_.positions[v]);
    const std::vector<Eigen::Vector3d> unknown(loop.size(), Eigen::Vector3d::Zero());
    for (const Triangle& t : TriangulateLoop(places, unknown, [](int32_t, int32_t) { return true; })) {
      patch_.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
    }
  }
  void CloseAbout(const Point3& tip) {
    patch_.new_points = {tip};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, hole_.size()});
  }

  void Untangle() {
    UntanglePatch(
        hole_, surface_, {}, [] { return false; }, patch_);
    DropUnusedPoints(hole_, patch_);
  }

  // The triangles that still cross.
  std::vector<int32_t> Crossed() {
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), [&](const Point3&, const Point3&) { return surface_; },
                        {});
    return check.Crossed(patch_);
  }

  const CellHoles work_ = WorkOfSheet(Disc(0, -5, 2), FoldToBuilding, 0);
  const CellBand band_{work_};
  LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  LocalPatch patch_;
  // A needle that stands across the ground.
  std::vector<SpaceTriangle> surface_ = {{Point3(0.3, -5.2, -0.2), Point3(0.31, -5.2, -0.2), Point3(0.3, -5.2, 0.1)}};
};

TEST_F(UntanglePatchTest, GoesAroundWhatStandsInTheWayOfTrianglesWithoutPoints) {
  CloseWithoutPoints();
  ASSERT_THAT(Crossed(), Not(IsEmpty()));
  Untangle();
  EXPECT_THAT(Crossed(), IsEmpty());
  EXPECT_THAT(patch_.new_points, Not(IsEmpty()));
  for (const Triangle& t : patch_.triangles) {
    EXPECT_GT(TwiceVectorArea(InSpace(hole_, patch_, t)).z(), 0) << "faces up";
  }
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(patch_)));
}

TEST_F(UntanglePatchTest, PutsAPointBackThatLiesBeyondTheRim) {
  surface_.clear();
  CloseAbout({2.6, -5, 0});
  ASSERT_THAT(Crossed(), Not(IsEmpty()));
  Untangle();
  EXPECT_THAT(Crossed(), IsEmpty());
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(patch_)));
}

TEST_F(UntanglePatchTest, KeepsWaterAtItsLevel) {
  hole_.level = 0;
  CloseAbout({0, -5, 0});
  ASSERT_THAT(Crossed(), Not(IsEmpty()));
  Untangle();
  EXPECT_THAT(patch_.new_points, Each(Truly([](const Point3& p) { return p.z() == 0; })));
}

// Where the hole ends at the tile's own outline, the surface of the piece beyond passes through its edge.
TEST(UntanglePatchAtOutlineTest, EndsOverTheSurfaceBeyond) {
  const CellHoles work = HoleAtOutline();
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  LocalPatch patch;
  patch.new_points = {{2, 2, 5}};
  for (const RegionSegment& s : hole.segments) patch.triangles.push_back({s.from, s.to, 5});
  // It reaches 9 cm over the outline, on one side above the patch and on the other below.
  const std::vector<SpaceTriangle> surface = {{Point3(0.5, -1, 4.97), Point3(3.5, -1, 5.03), Point3(2, 0.09, 4.999)}};
  const auto crossed = [&] {
    return CrossingCheck(hole, ReachOf(work, work.holes[0]), [&](const Point3&, const Point3&) { return surface; }, {})
        .CrossedAvoidably(patch);
  };
  ASSERT_THAT(crossed(), Not(IsEmpty()));
  UntanglePatch(
      hole, surface, {}, [] { return false; }, patch);
  EXPECT_THAT(crossed(), IsEmpty());
  EXPECT_EQ(FaultOf(hole, patch), FillFailure::kNone);
  EXPECT_THAT(patch.left_edges, Not(IsEmpty()));
}

// Fins across the ground, between which no single change makes the curves shorter in the end.
TEST_F(UntanglePatchTest, LeavesALocalMinimum) {
  std::minstd_rand random(15);
  const auto draw = [&](double lo, double hi) { return lo + (hi - lo) * static_cast<double>(random() % 1000) / 1000; };
  surface_.clear();
  for (int k = 0; k < 4; ++k) {
    const double y = -5 + draw(-1, 1), x = draw(-1, 1), along_y = draw(-0.4, 0.4), along_x = draw(-0.4, 0.4);
    const Point3 at(x, y, -0.2), along(along_x, along_y, 0), up(0, 0, draw(0.25, 0.8));
    surface_.push_back({at, Point3(at + along), Point3(at + 0.5 * along + up)});
  }
  CloseWithoutPoints();
  ASSERT_THAT(Crossed(), Not(IsEmpty()));
  Untangle();
  EXPECT_THAT(Crossed(), IsEmpty());
  EXPECT_EQ(FaultOf(hole_, patch_), FillFailure::kNone);
}

TEST_F(UntanglePatchTest, LeavesASoundPatchAsItIs) {
  surface_.clear();
  CloseAbout({0, -5, 0.2});
  const LocalPatch before = patch_;
  Untangle();
  EXPECT_EQ(patch_.new_points, before.new_points);
  EXPECT_EQ(patch_.triangles, before.triangles);
}

TEST_F(UntanglePatchTest, ChangesNothingOnceCancelled) {
  CloseWithoutPoints();
  const LocalPatch before = patch_;
  UntanglePatch(
      hole_, surface_, {}, [] { return true; }, patch_);
  EXPECT_EQ(patch_.triangles, before.triangles);
}

}  // namespace
}  // namespace tilemend
