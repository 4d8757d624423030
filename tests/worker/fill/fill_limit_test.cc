// How large the patches of one cell may be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
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

// Which holes stay open if the result may have so many points.
std::vector<bool> LeftOpen(const CellHoles& work, int64_t points) {
  FillOptions options;
  options.refine.max_new_points = points;
  std::vector<bool> left;
  for (const HolePatch& patch : FillHoles(work, options)) {
    left.push_back(!patch.failure.empty());
    if (patch.failure.empty()) continue;
    EXPECT_THAT(patch.failure, HasSubstr("more than 4 million vertices"));
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

}  // namespace
}  // namespace tilemend
