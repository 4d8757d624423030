#include "worker/fill/plane/upright_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/folded_meshes.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {
namespace {

using ::testing::SizeIs;

// A hole that is the holes of a sheet folded to a building, together.
class UprightLoopsTest : public testing::Test {
 protected:
  // What is above the ground stands on objects.
  static CellHoles WorkOfHoles(const std::function<bool(double, double)>& second) {
    CellHoles work =
        WorkOfSheet([&](double u, double v) { return Disc(0, -5, 2)(u, v) || second(u, v); }, FoldToBuilding, 0);
    for (RimVertex& v : work.vertices) v.on_object = v.position.z() > 0;
    return work;
  }

  explicit UprightLoopsTest(const std::function<bool(double, double)>& second = Disc(0, 5, 2))
      : work_(WorkOfHoles(second)) {}

  std::optional<UprightLoops> CloseWith(const std::vector<SpaceTriangle>& surface = {}) {
    const SurfaceNear near = [&](const Point3&, const Point3&) { return surface; };
    CrossingCheck check(hole_, ReachOf(work_, work_.holes[0]), near, {});
    return CloseUprightLoops(work_.holes[0], hole_, check);
  }

  // Of the edges of the hole's boundary.
  int64_t CountOnWall() const {
    return std::ranges::count_if(hole_.segments,
                                 [&](const RegionSegment& s) { return hole_.positions[s.from].z() > 0; });
  }

  const CellHoles work_;
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
};

TEST_F(UprightLoopsTest, ClosesAHoleInAWallAndLeavesTheOneInTheGround) {
  const std::optional<UprightLoops> loops = CloseWith();
  ASSERT_TRUE(loops);
  EXPECT_THAT(loops->triangles, SizeIs(CountOnWall() - 2));
  for (const Triangle& t : loops->triangles) {
    for (const int32_t v : t) EXPECT_GT(hole_.positions[v].z(), 0);
  }
  const HolePart& rest = loops->rest;
  EXPECT_THAT(rest.hole.segments, SizeIs(hole_.segments.size() - static_cast<size_t>(CountOnWall())));
  ASSERT_EQ(rest.hole.positions.size(), rest.vertices.size());
  for (size_t v = 0; v < rest.vertices.size(); ++v) {
    EXPECT_EQ(rest.hole.positions[v], hole_.positions[rest.vertices[v]]);
    EXPECT_EQ(rest.hole.positions[v].z(), 0);
  }
}

TEST(UprightLoopsInGroundTest, HaveNoWallsDownToIt) {
  // The wall leans over the ground, so that its hole is over the one there.
  const auto lean = [](const Point3& p) {
    const Point3 q = FoldToBuilding(p);
    return Point3(q.x(), q.y() - q.z() / 2, q.z());
  };
  CellHoles work = WorkOfSheet([](double u, double v) { return Disc(0, -4, 2)(u, v) || Disc(0, 5, 2)(u, v); }, lean, 0);
  for (RimVertex& v : work.vertices) v.on_object = v.position.z() > 0;
  work.holes[0].open = work.holes[0].own_outline = true;
  const std::vector<HolePatch> patches = FillHoles(work, With(Surface::kThinPlate));
  ASSERT_THAT(patches, SizeIs(1));
  ExpectClosesHole(work, work.holes[0], patches[0]);
  const auto is_on_wall = [&](int32_t v) { return v >= 0 && work.vertices[v].position.z() > 0; };
  for (const Triangle& t : patches[0].triangles) {
    const auto on_wall = std::ranges::count_if(t, is_on_wall);
    EXPECT_TRUE(on_wall == 0 || on_wall == 3);
  }
}

TEST_F(UprightLoopsTest, TakesHeightsWhereAnotherPatchHasGround) {
  const int32_t n = hole_.size();
  const LocalPatch ground{FillFailure::kNone, {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}, {{n, n + 1, n + 2}}};
  LocalPatch patch{FillFailure::kNone, {{0, 0, 3}, {50, 0, 3}}};
  TakeHeights(hole_, ground, patch);
  EXPECT_EQ(patch.new_points[0], Point3(0, 0, 1));
  EXPECT_EQ(patch.new_points[1], Point3(50, 0, 3)) << "no ground is known there";
}

TEST_F(UprightLoopsTest, LeavesALoopThatSurfacePassesThrough) {
  EXPECT_FALSE(CloseWith({{Point3(0, -1, 5), Point3(0.3, -1, 5), Point3(0, 1, 5.2)}}));
}

// The second hole is in the roof, and stands on objects as well.
class LevelLoopsTest : public UprightLoopsTest {
 protected:
  LevelLoopsTest() : UprightLoopsTest(Disc(0, 15, 2)) {}
};

TEST_F(LevelLoopsTest, AreNone) { EXPECT_FALSE(CloseWith()); }

// The second hole is in the wall down to the ground.
class LoopsToTheGroundTest : public UprightLoopsTest {
 protected:
  LoopsToTheGroundTest() : UprightLoopsTest([](double u, double v) { return std::abs(u) < 3 && v > 0 && v < 6; }) {}
};

TEST_F(LoopsToTheGroundTest, AreNone) { EXPECT_FALSE(CloseWith()); }

}  // namespace
}  // namespace tilemend
