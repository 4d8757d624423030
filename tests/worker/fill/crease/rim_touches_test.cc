#include "worker/fill/crease/rim_touches.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// A loop around a square of 8 x 8, an edge each metre, whose lower side has one vertex drawn in to (4, `tip`).
RimLoop SquareWithATip(double tip) {
  RimLoop loop;
  for (int k = 0; k < 8; ++k) loop.positions.emplace_back(k, k == 4 ? tip : 0, 0);
  for (int k = 0; k < 8; ++k) loop.positions.emplace_back(8, k, 0);
  for (int k = 8; k > 0; --k) loop.positions.emplace_back(k, 8, 0);
  for (int k = 8; k > 0; --k) loop.positions.emplace_back(0, k, 0);
  for (size_t k = 0; k < loop.positions.size(); ++k) loop.vertices.push_back(static_cast<int32_t>(k));
  return loop;
}

// From (0, 4) to (8, 4).
CreaseCurve Across() {
  CreaseCurve curve;
  curve.start = {0, 4, 0};
  curve.finish = {8, 4, 0};
  curve.start_slope = curve.finish_slope = {8, 0, 0};
  return curve;
}

bool IsAtAnEnd(const RimTouch& touch) { return touch.place == 12 || touch.place == 28; }

TEST(RimTouchesTest, FindsAVertexOnACurve) {
  const std::vector<RimLoop> loops = {SquareWithATip(4)};
  const auto touch = RimTouches(loops).FirstOn(Across(), IsAtAnEnd);
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(touch->loop, 0);
  EXPECT_EQ(touch->place, 4);
  EXPECT_NEAR(touch->at, 0.5, 1e-9);
}

TEST(RimTouchesTest, LeavesOutEndsAndWhatLiesOff) {
  const std::vector<RimLoop> off = {SquareWithATip(1)};
  EXPECT_FALSE(RimTouches(off).FirstOn(Across(), IsAtAnEnd).has_value());
  const auto end = RimTouches(off).FirstOn(Across(), [](const RimTouch&) { return false; });
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->place, 12) << "the first of the two";
}

}  // namespace
}  // namespace tilemend
