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

namespace tilemend {
namespace {

using ::testing::IsEmpty;
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
