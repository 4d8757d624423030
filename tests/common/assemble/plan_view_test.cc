#include "common/assemble/plan_view.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

Eigen::AlignedBox2d Box(double x0, double y0, double x1, double y1) { return {Point2(x0, y0), Point2(x1, y1)}; }

TEST(PlanViewTest, CoversWhatLiesUnderATriangle) {
  // One triangle faces up, one down, one stands upright.
  const PlanView view({{Point3(0, 0, 5), Point3(4, 0, 5), Point3(0, 4, 9)},
                       {Point3(10, 0, 0), Point3(10, 4, 0), Point3(14, 0, 0)},
                       {Point3(20, 0, 0), Point3(24, 0, 0), Point3(22, 0, 3)}});
  EXPECT_TRUE(view.Covers({1, 1}));
  EXPECT_TRUE(view.Covers({2, 2})) << "on a side";
  EXPECT_FALSE(view.Covers({3, 3}));
  EXPECT_TRUE(view.Covers({11, 1}));
  EXPECT_FALSE(view.Covers({22, 0}));
  EXPECT_FALSE(view.Covers({-100, 0}));
}

TEST(PlanViewTest, MeetsBoxes) {
  const PlanView view({{Point3(0, 0, 5), Point3(4, 0, 5), Point3(0, 4, 9)}});
  EXPECT_TRUE(view.Meets(Box(3, 3, 5, 5))) << "the box of the triangle";
  EXPECT_FALSE(view.Meets(Box(5, 0, 6, 4)));
}

TEST(PlanViewTest, OfNothingNothingIsCovered) {
  const PlanView view({});
  EXPECT_FALSE(view.Covers({0, 0}));
  EXPECT_FALSE(view.Meets(Box(-1, -1, 1, 1)));
}

}  // namespace
}  // namespace tilemend
