#include "coordinator/plan/hole/rim_slopes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

const Point2 kSlope(0.6, -0.3);

double Hillside(double x, double y) { return 40 + kSlope.x() * x + kSlope.y() * y; }

// A hole over four cells, one closed, one that reaches the edge of the area.
SurveyedScene HolesIn(const HeightFunction& height) {
  return PictureScene({"######|######|######",  //
                       "######|######|######",  //
                       "###...|..####|######",  //
                       "##....|..####|##..##",  //
                       "##....|..####|#...##",  //
                       "##....|..####|######",  //
                       "------+------+------",  //
                       "##....|..####|######",  //
                       "##....|..####|######",  //
                       "######|######|####..",  //
                       "######|##..##|###...",  //
                       "######|######|####..",  //
                       "######|######|######"},
                      6, height);
}

TEST(RimSlopesTest, AreThoseOfTheGroundInEveryCell) {
  const SurveyedScene scene = HolesIn(Hillside);
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_GE(plan.holes.size(), 7U) << CountsOf(plan);
  int at_edge = 0;
  for (const PlannedHole& hole : plan.holes) {
    const bool reaches_edge = hole.cell == CellId{2, 0};
    at_edge += reaches_edge;
    EXPECT_LT((hole.slope - kSlope).norm(), reaches_edge ? 0.2 : 1e-5) << hole.slope.transpose();
  }
  EXPECT_EQ(at_edge, 1);
}

TEST(RimSlopesTest, AcrossAStraightRimAtTheEdgeOfTheAreaThereIsNone) {
  const Plan plan = MakePlan(PictureScene({"######|###...",  //
                                           "######|###...",  //
                                           "######|###...",  //
                                           "######|###...",  //
                                           "######|###...",  //
                                           "######|###..."},
                                          6, Hillside)
                                 .Input(),
                             {});
  ASSERT_EQ(plan.holes.size(), 1U) << CountsOf(plan);
  EXPECT_NEAR(plan.holes[0].slope.x(), 0, 0.03);
  EXPECT_NEAR(plan.holes[0].slope.y(), kSlope.y(), 0.06);
}

TEST(RimSlopesTest, OfAClusterAreTheSameInAllItsHoles) {
  const SurveyedScene scene =
      HolesIn([](double x, double y) { return Hillside(x, y) + std::sin(x * 1.7) + 0.1 * y * y; });
  const Plan plan = MakePlan(scene.Input(), {});
  for (const PlannedHole& a : plan.holes) {
    for (const PlannedHole& b : plan.holes) {
      if (a.cluster >= 0 && a.cluster == b.cluster) {
        EXPECT_EQ(a.slope, b.slope);
      }
    }
  }
}

TEST(RimSlopesTest, EndAtSteepGround) {
  const Plan plan = MakePlan(HolesIn([](double x, double) { return 7 * x; }).Input(), {});
  ASSERT_FALSE(plan.holes.empty());
  for (const PlannedHole& hole : plan.holes) EXPECT_NEAR(hole.slope.norm(), 2, 1e-5);
}

TEST(RimSlopesTest, AreNoneInGentleGround) {
  const Plan plan = MakePlan(HolesIn([](double x, double) { return 0.2 * x; }).Input(), {});
  ASSERT_FALSE(plan.holes.empty());
  for (const PlannedHole& hole : plan.holes) EXPECT_EQ(hole.slope, Point2(0, 0));
}

TEST(RimSlopesTest, AreNoneWhereTheRimFacesDown) {
  Plan plan;
  for (const Point3& p : {Point3(0, 0, 0), Point3(0, 1, 1), Point3(1, 0, 2)}) {
    plan.vertices.push_back({{0, 0}, static_cast<int32_t>(plan.vertices.size()), p});
  }
  plan.holes.emplace_back();
  plan.holes[0].segments = {{0, 1, false}, {1, 2, false}, {2, 0, false}};
  FindRimSlopes(plan);
  EXPECT_EQ(plan.holes[0].slope, Point2(0, 0));
}

}  // namespace
}  // namespace tilemend
