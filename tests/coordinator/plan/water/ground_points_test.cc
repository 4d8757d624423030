#include "coordinator/plan/water/ground_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

double Ground(double x, double y) { return 0.05 * x + 0.5 * std::sin(y / 15); }

bool InHouse(double y) { return std::fmod(y, 24) < 10; }

// Rows of houses on both shores.
Plan PlanAmongHouses(Cut cut) {
  return MakePlan(SurveyScene(MakeScene(HoleOverNineCells(
                                  cut, [](double, double x, double y) { return Ground(x, y) + (InHouse(y) ? 9 : 0); })))
                      .Input(),
                  {});
}

class GroundPointsTest : public ::testing::TestWithParam<Cut> {};

TEST_P(GroundPointsTest, AreOnTheGroundOfTheWholeRim) {
  const Plan plan = PlanAmongHouses(GetParam());
  const double reach = 40 + 1;
  for (const PlannedHole& hole : plan.holes) {
    ASSERT_TRUE(hole.among_objects);
    ASSERT_FALSE(hole.ground_points.empty());
    for (const Point3& p : hole.ground_points) EXPECT_NEAR(p.z(), Ground(p.x(), p.y()), 0.4) << p.transpose();
    const bool beyond = std::any_of(hole.ground_points.begin(), hole.ground_points.end(), [&](const Point3& p) {
      const Point2 corner(hole.cell.col * 40.0, hole.cell.row * 40.0);
      return (p.head<2>() - corner).minCoeff() < -1 || (p.head<2>() - corner).maxCoeff() > reach;
    });
    EXPECT_TRUE(beyond) << hole.cell.col << ' ' << hole.cell.row;
  }
}

TEST_P(GroundPointsTest, AreTheLowestAround) {
  Plan plan = PlanAmongHouses(GetParam());
  for (size_t v = 0; v < plan.vertices.size(); v += 7) plan.vertices[v].position.z() += 1.5;  // cars, as it were
  FindGroundPoints(plan);
  int lowered = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const Point3& p : hole.ground_points) {
      for (const RimSegment& s : hole.segments) {
        const PlanVertex& v = plan.vertices[s.from];
        const double apart = (v.position - p).head<2>().norm();
        if (v.index < 0 || v.on_object || apart > 2) continue;
        EXPECT_LE(p.z(), v.position.z()) << p.transpose();
        lowered += apart == 0 && p.z() < v.position.z() - 1;
      }
    }
  }
  EXPECT_GT(lowered, 5);
}

// Towers on both shores of a narrow hole, on one podium from 44 to 74 m along y.
TEST_P(GroundPointsTest, APodiumGoesOnBetweenTowers) {
  SceneMakerOptions scene = HoleOverNineCells(GetParam(), [](double, double x, double y) {
    return Ground(x, y) + (y > 44 && y < 66 ? 40 : y >= 66 && y < 74 ? 12 : 0);
  });
  scene.ellipses.front().radii = {18, 47};
  const Plan plan = MakePlan(SurveyScene(MakeScene(scene)).Input(), {});
  int on_top = 0, at_foot = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const Point3& p : hole.ground_points) {
      if (std::abs(p.x() - 61) > 12) continue;  // near the shore
      on_top += p.z() > 12;
      at_foot += p.z() < 6 && (std::abs(p.y() - 44) < 3 || std::abs(p.y() - 74) < 3);
      EXPECT_TRUE(p.z() < 12 || (p.y() > 43 && p.y() < 75)) << p.transpose();
    }
  }
  EXPECT_GT(on_top, 20);
  EXPECT_GT(at_foot, 20);
}

TEST_P(GroundPointsTest, ThereAreNoneWhereFewObjectsStand) {
  const Plan plan = MakePlan(
      SurveyScene(MakeScene(HoleOverNineCells(GetParam(), [](double, double x, double y) { return Ground(x, y); })))
          .Input(),
      {});
  for (const PlannedHole& hole : plan.holes) EXPECT_TRUE(hole.ground_points.empty());
}

INSTANTIATE_TEST_SUITE_P(Cuts, GroundPointsTest, ::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap),
                         [](const auto& cut) { return NameOf(cut.param); });

}  // namespace
}  // namespace tilemend
