#include "coordinator/report/outline_holes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void AddHole(const std::vector<Point3>& ring, Plan& plan) {
  const auto first = static_cast<int32_t>(plan.vertices.size()), count = static_cast<int32_t>(ring.size());
  PlannedHole& hole = plan.holes.emplace_back();
  for (int32_t k = 0; k < count; ++k) {
    plan.vertices.emplace_back().position = ring[k];
    hole.segments.push_back({first + k, first + (k + 1) % count});
  }
}

TEST(OutlineHolesTest, AHoleAroundTheWholeMeshIsProbablyItsOutline) {
  Plan plan;
  AddHole({{2, 2, 1}, {3, 2, 1}, {3, 3, 1}}, plan);
  AddHole({{0, 0, 1}, {9, 0.0005, 2}, {9, 9, 3}, {0, 9, 1}}, plan);
  const auto holes = OutlineHoles(plan, {0, 0, 0}, {9, 9, 7});
  EXPECT_THAT(holes, ElementsAre(1));
  EXPECT_THAT(OutlineHolesText(plan, holes), HasSubstr("hole 1 is as large as the whole mesh"));
  EXPECT_THAT(OutlineHolesText(plan, holes), HasSubstr("--largest-hole 3`"));
}

TEST(OutlineHolesTest, OthersAreNot) {
  Plan plan;
  AddHole({{0, 0, 1}, {9, 0, 1}, {9, 8.98, 1}, {0, 8.98, 1}}, plan);
  EXPECT_THAT(OutlineHoles(plan, {0, 0, 0}, {9, 9, 7}), IsEmpty());
  EXPECT_EQ(OutlineHolesText(plan, {}), "");
  // A slit along all of a flat mesh.
  Plan slit;
  AddHole({{0, 4, 0}, {9, 4, 0}, {9, 5, 0}, {0, 5, 0}}, slit);
  EXPECT_THAT(OutlineHoles(slit, {0, 0, 0}, {9, 9, 0}), IsEmpty());
}

}  // namespace
}  // namespace tilemend
