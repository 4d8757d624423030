#include "worker/fill/plane/upright_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
  explicit UprightLoopsTest(bool is_in_wall = true)
      : work_(WorkOfSheet(
            [=](double u, double v) { return Disc(0, -5, 2)(u, v) || Disc(0, is_in_wall ? 5 : -9, 2)(u, v); },
            FoldToBuilding, 0)) {}

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

class LevelLoopsTest : public UprightLoopsTest {
 protected:
  LevelLoopsTest() : UprightLoopsTest(false) {}
};

TEST_F(LevelLoopsTest, AreNone) { EXPECT_FALSE(CloseWith()); }

}  // namespace
}  // namespace tilemend
