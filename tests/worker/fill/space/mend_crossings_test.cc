#include "worker/fill/space/mend_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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

// Cancelled after any number of questions, it is what it was or sound, and there are no more questions.
TEST_F(MendCrossingsTest, EndsSoonWhereverItIsCancelled) {
  CloseAbout({9, -5, 0});
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), {}, {});
  bool is_mended = false;
  for (int end = 1; !is_mended; ++end) {
    int asked = 0;
    const LocalPatch patch = MendCrossings(hole_, patch_, check, [&] { return ++asked >= end; });
    is_mended = check.Crossed(patch).empty();
    EXPECT_EQ(FaultOf(hole_, patch), FillFailure::kNone);
    EXPECT_EQ(patch.crossings, std::ssize(check.CrossedAvoidably(patch)));
    ASSERT_LT(end, 100);
    EXPECT_TRUE(end > 1 || patch.triangles == patch_.triangles);
  }
}

TEST_F(MendCrossingsTest, GoesAroundSurfaceInTheHole) {
  CloseAbout({0, -5, 0});
  LocalPatch mended = Mended({Across(0.6, -4.8)});
  EXPECT_THAT(crossed_, IsEmpty());
  ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(mended)));
}

// The blade passes through the hole's boundary at one edge. Through the triangle there it passes in any patch. The
// needle beside it can be gone around.
TEST_F(MendCrossingsTest, GoesAroundSurfaceBesideWhatPassesThroughTheRim) {
  const RegionSegment& s = hole_.segments[0];
  const Point3 on = (hole_.positions[s.from] + hole_.positions[s.to]) / 2, centre(0, -5, 0);
  const Point3 in = on + 0.1 * (centre - on), out = on - 0.1 * (centre - on), up(0, 0, 0.3);
  CloseAbout(centre);
  const Point3 needle = on + 0.5 * (centre - on);
  std::vector<SpaceTriangle> surface = {{out - up, in - up, on + up}, Across(needle.x(), needle.y())};
  const std::vector<Point3>& points = work_.band.points;
  for (const Triangle& t : work_.band.triangles) surface.push_back({points[t[0]], points[t[1]], points[t[2]]});
  const SurfaceNear near = [&](const Point3&, const Point3&) { return surface; };
  CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
  ASSERT_THAT(check.CrossedAvoidably(patch_), SizeIs(1));
  LocalPatch mended = Mended(surface);
  EXPECT_THAT(check.CrossedAvoidably(mended), IsEmpty());
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

// A hole of two discs of the same size: one in the ground and one in the wall.
class MendCrossingsOfTwoTest : public testing::Test {
 protected:
  // Each loop, from its vertex that is lowest in y and z, then x.
  std::vector<std::vector<int32_t>> Loops() const {
    std::vector<std::vector<int32_t>> loops = LoopsOf(hole_.segments);
    for (std::vector<int32_t>& loop : loops) {
      const auto key = [&](int32_t v) {
        const Point3& p = hole_.positions[v];
        return std::pair(p.y() + p.z(), p.x());
      };
      std::ranges::rotate(loop, std::ranges::min_element(loop, {}, key));
    }
    return loops;
  }

  void ExpectMended(LocalPatch patch) {
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), {}, {});
    ASSERT_THAT(check.Crossed(patch), SizeIs(patch.triangles.size()));
    LocalPatch mended = MendCrossings(hole_, std::move(patch), check);
    EXPECT_THAT(check.Crossed(mended), IsEmpty());
    const std::vector<int32_t> first = Loops()[0];
    for (const Triangle& t : mended.triangles) {
      const auto in_first = [&](int32_t v) { return std::ranges::find(first, v) != first.end(); };
      EXPECT_EQ(in_first(t[0]), in_first(t[1]));
      EXPECT_EQ(in_first(t[0]), in_first(t[2]));
    }
    ExpectClosesHole(work_, work_.holes[0], ToHolePatch(hole_, std::move(mended)));
  }

  const CellHoles work_ =
      WorkOfSheet([](double u, double v) { return Disc(0, -5, 2)(u, v) || Disc(0, 5, 2)(u, v); }, FoldToBuilding, 0);
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

// Each passes through the other's hole: neither can be closed while the other one is there.
TEST_F(MendCrossingsOfTwoTest, TakesOutPiecesTogetherThatCrossEachOther) {
  LocalPatch patch;
  for (size_t k = 0; k < 2; ++k) {
    const std::vector<int32_t> loop = Loops()[k];
    const bool is_in_ground = hole_.positions[loop[0]].z() == 0;
    patch.new_points.push_back(is_in_ground ? Point3(0, 4.5, 9.5) : Point3(0, -40, -35));
    for (size_t i = 0; i < loop.size(); ++i) {
      patch.triangles.push_back({loop[i], loop[(i + 1) % loop.size()], hole_.size() + static_cast<int32_t>(k)});
    }
  }
  ExpectMended(std::move(patch));
}

// A tube between both that is twisted by nearly half a turn.
TEST_F(MendCrossingsOfTwoTest, ClosesTheLoopsOfAPieceOneByOne) {
  const std::vector<int32_t> a = Loops()[0], b = Loops()[1];
  const size_t n = a.size();
  ASSERT_EQ(n, b.size());
  LocalPatch patch;
  for (size_t i = 0; i < n; ++i) {
    const auto opposite = [&](size_t k) { return b[(2 * n + 1 - k) % n]; };
    patch.triangles.push_back({a[i], a[(i + 1) % n], opposite(i)});
    patch.triangles.push_back({a[(i + 1) % n], opposite(i + 1), opposite(i)});
  }
  ExpectMended(std::move(patch));
}

// Two holes that touch at a corner, closely between two other surfaces. One disc closes both, so its boundary passes
// the corner twice; every such disc passes through something.
TEST(MendCrossingsOfTouchingTest, CutsTheBoundaryWhereItTouchesItself) {
  const auto is_hole = [](double u, double v) {
    return (u > -2 && u < 0 && v > -6 && v < -4) || (u > 0 && u < 2 && v > -4 && v < -2);
  };
  const CellHoles work = WorkOfSheet(is_hole, FoldToBuilding, 0);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  std::vector<int32_t> around;  // as the boundary passes them
  for (const std::vector<int32_t>& loop : LoopsOf(hole.segments)) {
    const auto corner = std::ranges::find(loop, Point3(0, -4, 0), [&](int32_t v) { return hole.positions[v]; });
    ASSERT_NE(corner, loop.end());
    around.insert(around.end(), corner, loop.end());
    around.insert(around.end(), loop.begin(), corner);
  }
  ASSERT_EQ(std::ranges::count(around, around[0]), 2);
  LocalPatch patch;
  patch.new_points = {Point3(9, -4, 0)};
  patch.triangles = {{around.back(), around[0], around[1]}};
  for (size_t i = 1; i + 1 < around.size(); ++i) patch.triangles.push_back({around[i], around[i + 1], hole.size()});
  patch.triangles.push_back({around.back(), around[1], hole.size()});
  const SurfaceNear near = [&](const Point3&, const Point3&) {
    std::vector<SpaceTriangle> surface;
    const std::vector<Point3>& points = work.band.points;
    for (const Triangle& t : work.band.triangles) surface.push_back({points[t[0]], points[t[1]], points[t[2]]});
    for (const double z : {-0.01, 0.01}) surface.push_back({Point3(-20, -9, z), Point3(20, -9, z), Point3(0, -0.5, z)});
    return surface;
  };
  CrossingCheck check(hole, ReachOf(work, work.holes[0]), near, {});
  ASSERT_TRUE(check.Crosses(patch));
  LocalPatch mended = MendCrossings(hole, std::move(patch), check);
  EXPECT_THAT(check.Crossed(mended), IsEmpty());
  EXPECT_THAT(mended.new_points, IsEmpty());
  EXPECT_THAT(mended.triangles, SizeIs(around.size() - 4)) << "as of two loops";
  ExpectClosesHole(work, work.holes[0], ToHolePatch(hole, std::move(mended)));
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
