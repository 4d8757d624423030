#include "worker/fill/space/cone_fill.h"

#include <gtest/gtest.h>

#include <optional>
#include <span>
#include <vector>

namespace tilemend {
namespace {

const std::vector<Point3> kSquare = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(4, 4, 0), Point3(0, 4, 0)};
const std::vector<Eigen::Vector3d> kUp(4, Eigen::Vector3d::UnitZ());
bool AnyChord(int32_t, int32_t) { return true; }
Point3 Anywhere(const Point3& p) { return p; }

// Upright, in the middle of the square, through both of its diagonals.
const SpaceTriangle kFin = {Point3(1.5, 1.5, 1), Point3(2.5, 2.4, 1), Point3(2, 2, -0.3)};

TEST(ConeFillTest, PassesAFinByOffThePlane) {
  const CrossingIndex surface(std::span<const SpaceTriangle>(&kFin, 1));
  ASSERT_TRUE(surface.IsCrossedBy({kSquare[0], kSquare[1], kSquare[2]}));
  const std::optional<ConeFill> cone = CloseByCone(kSquare, kUp, AnyChord, surface, Anywhere);
  ASSERT_TRUE(cone);
  EXPECT_LT(cone->tip.z(), -0.3);
  ASSERT_EQ(cone->triangles.size(), 4u);
  for (const Triangle& t : cone->triangles) {
    EXPECT_EQ(t[2], 4);
    EXPECT_FALSE(surface.IsCrossedBy({kSquare[t[0]], kSquare[t[1]], cone->tip}));
  }
}

TEST(ConeFillTest, TakesTheMiddleWhereNothingStands) {
  const std::optional<ConeFill> cone = CloseByCone(kSquare, kUp, AnyChord, CrossingIndex({}), Anywhere);
  ASSERT_TRUE(cone);
  EXPECT_NEAR((cone->tip - Point3(2, 2, 0)).norm(), 0, 1e-9);
}

// Two squares that touch at a corner: with one tip for both, the edge from there to the corner would have four
// triangles.
TEST(ConeFillTest, JoinsNoPlaceTwice) {
  std::vector<Point3> loop = kSquare;
  for (const Point3& p : kSquare) loop.push_back(kSquare[0] + Point3(-p.y(), -p.x(), p.x() + p.y()));
  const std::vector<Eigen::Vector3d> outside(loop.size(), Eigen::Vector3d::Zero());
  ASSERT_EQ(loop[4], loop[0]);
  const std::optional<ConeFill> cone = CloseByCone(loop, outside, AnyChord, CrossingIndex({}), Anywhere);
  ASSERT_TRUE(cone.has_value());
  const auto joins = [&](int32_t v) {
    return std::ranges::any_of(cone->triangles, [&](const Triangle& t) { return t[2] == 8 && t[0] == v; });
  };
  EXPECT_FALSE(joins(0) && joins(4));
}

TEST(ConeFillTest, GivesUpWhereASideIsCrossed) {
  const SpaceTriangle blade = {Point3(2, -1, -9), Point3(2, 5, -9), Point3(2, 2, 30)};
  const CrossingIndex surface(std::span<const SpaceTriangle>(&blade, 1));
  EXPECT_FALSE(CloseByCone(kSquare, kUp, AnyChord, surface, Anywhere));
}

}  // namespace
}  // namespace tilemend
