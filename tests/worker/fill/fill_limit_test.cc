// How large the patches of one cell may be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Two open holes of four edges a side.
CellHoles TwoHoles() {
  const TriMesh mesh = PictureMesh({"############",  //
                                    "#....##....#",  //
                                    "#....##....#",  //
                                    "#....##....#",  //
                                    "#....##....#",  //
                                    "############"},
                                   Flat);
  const auto inside = [](const Point3& p) { return p.x() > 0 && p.y() > 0 && p.x() < 12 && p.y() < 6; };
  CellHoles work = WorkOf(mesh, true, [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
  const std::vector<RimSegment> both = work.holes[0].segments;
  const auto middle = both.begin() + std::ssize(both) / 2;
  work.holes[0].segments.assign(both.begin(), middle);
  work.holes.push_back(work.holes[0]);
  work.holes[1].id = 1;
  work.holes[1].segments.assign(middle, both.end());
  return work;
}

// A closed hole of four edges a side.
CellHoles ClosedHole() {
  const TriMesh mesh = PictureMesh({"######", "#....#", "#....#", "#....#", "#....#", "######"}, Flat);
  const auto inside = [](const Point3& p) { return p.x() > 0 && p.y() > 0 && p.x() < 6 && p.y() < 6; };
  return WorkOf(mesh, false, [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
}

// Which holes stay open if the result may have so many points.
std::vector<bool> LeftOpen(const CellHoles& work, int64_t points) {
  FillOptions options;
  options.refine.max_new_points = points;
  std::vector<bool> left;
  for (const HolePatch& patch : FillHoles(work, options)) {
    left.push_back(!patch.failure.empty());
    if (patch.failure.empty()) continue;
    EXPECT_THAT(patch.failure, HasSubstr(std::to_string(points) + " vertices or more"));
    EXPECT_THAT(patch.triangles, IsEmpty());
  }
  return left;
}

TEST(FillLimitTest, LeavesAHoleOpenWhosePatchDoesNotFitIntoTheResult) {
  const CellHoles work = TwoHoles();
  const std::vector<HolePatch> whole = FillHoles(work, {});
  const auto vertices = std::ssize(work.vertices), first = std::ssize(whole.at(0).new_points),
             second = std::ssize(whole.at(1).new_points);
  ASSERT_GT(first, 0);
  ASSERT_EQ(first, second);
  EXPECT_EQ(LeftOpen(work, vertices + first + second + 1), std::vector({false, false}));
  EXPECT_EQ(LeftOpen(work, vertices + first + second), std::vector({false, true}));
  EXPECT_EQ(LeftOpen(work, vertices + first), std::vector({true, true}));
  EXPECT_EQ(LeftOpen(work, 0), std::vector({true, true}));
}

// Among other ways are those in space, which ask for the surface around the hole.
TEST(FillLimitTest, TriesNoOtherWayOnceAPatchIsTooLarge) {
  const CellHoles work = ClosedHole();
  FillOptions options;
  options.refine.max_new_points = std::ssize(work.vertices) + 1;
  int asked = 0;
  const SurfaceNear near = [&](const Point3&, const Point3&) {
    ++asked;
    return std::vector<SpaceTriangle>();
  };
  EXPECT_THAT(FillHoles(work, options, near).at(0).failure, HasSubstr("vertices or more"));
  EXPECT_EQ(asked, 0);
}

TEST(FillLimitTest, NamesNoCellsInASingleMesh) {
  FillOptions options;
  options.refine.max_new_points = 1;
  EXPECT_THAT(FillHoles(ClosedHole(), options).at(0).failure, HasSubstr("the fill of its cell"));
  options.is_single_mesh = true;
  EXPECT_THAT(FillHoles(ClosedHole(), options).at(0).failure, HasSubstr("the fill of the mesh"));
}

TEST(FillLimitTest, LooksAtTheSizeOfAPatchBeforeAllElse) {
  PublishedWays ways;
  ways.by_name = [](const LocalHole&, const FillOptions& options, const SurroundingTriangles&) {
    LocalPatch far_away;
    far_away.new_points.assign(options.refine.max_new_points, Point3(1e6, 0, 0));
    return far_away;
  };
  FillOptions options;
  options.filler = Filler::kMinimumArea;
  options.published = &ways;
  options.refine.max_new_points = 1000;
  EXPECT_THAT(FillHoles(ClosedHole(), options).at(0).failure, HasSubstr("1000 vertices or more"));
}

}  // namespace
}  // namespace tilemend
