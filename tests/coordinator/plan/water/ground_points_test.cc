#include "coordinator/plan/water/ground_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "coordinator/plan/plan.h"
#include "coordinator/plan/water/platforms.h"
#include "coordinator/plan/water/shore_line.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

double Ground(double x, double y) { return 0.05 * x + 0.5 * std::sin(y / 15); }

bool InHouse(double y) { return std::fmod(y, 24) < 10; }

// Rows of houses on both shores.
Plan PlanAmongHouses(Cut cut, const PlanePolygon& area = {}) {
  const SurveyedScene scene = SurveyScene(MakeScene(
      HoleOverNineCells(cut, [](double, double x, double y) { return Ground(x, y) + (InHouse(y) ? 9 : 0); })));
  PlanInput input = scene.Input();
  input.area = area;
  return MakePlan(input, {});
}

// Every ground point of the plan, once, in order.
std::vector<std::array<double, 3>> GroundPointsOf(const Plan& plan) {
  std::set<std::array<double, 3>> points;
  for (const PlannedHole& hole : plan.holes) {
    for (const Point3& p : hole.ground_points) points.insert({p.x(), p.y(), p.z()});
  }
  return {points.begin(), points.end()};
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
  FindGroundPoints({}, plan);
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

// The shelf of the podium as ground that the street beside it lowers.
TEST_P(GroundPointsTest, WhereAPodiumIsItsHeightCounts) {
  SceneMakerOptions scene = HoleOverNineCells(GetParam(), [](double, double x, double y) {
    return Ground(x, y) + (y > 44 && y < 66 ? 40 : y >= 66 && y < 74 ? 12 : 0);
  });
  scene.ellipses.front().radii = {18, 47};
  Plan plan = MakePlan(SurveyScene(MakeScene(scene)).Input(), {});
  for (PlanVertex& v : plan.vertices) v.on_object = v.on_object && v.position.z() > 20;
  std::vector<int32_t> holes(plan.holes.size());
  std::iota(holes.begin(), holes.end(), 0);
  const ShoreLine shore = ShoreLineOf(plan, holes);
  std::map<std::pair<double, double>, double> platforms;
  for (const Point3& p : FindPlatforms(shore.points, shore.kinds, shore.edges)) {
    platforms.try_emplace({p.x(), p.y()}, p.z());
  }
  ASSERT_GT(platforms.size(), 20u);
  FindGroundPoints({}, plan);
  int shared = 0;
  for (const auto& [x, y, z] : GroundPointsOf(plan)) {
    const auto platform = platforms.find({x, y});
    if (platform == platforms.end()) continue;
    EXPECT_EQ(z, platform->second) << x << ' ' << y;
    ++shared;
  }
  EXPECT_GT(shared, 20);
}

TEST_P(GroundPointsTest, OfASmallAreaLieFarAround) {
  const Plan plan = PlanAmongHouses(GetParam(), {{{{60, 58}, {62, 58}, {62, 60}, {60, 60}}}});
  ASSERT_FALSE(plan.holes.empty());
  for (const PlannedHole& hole : plan.holes) EXPECT_GE(hole.ground_points.size(), 3u);
}

// A box that leaves 20 m of the shore, and one in the middle of the hole.
TEST_P(GroundPointsTest, InAnAreaAreThoseOfTheWholeShore) {
  const auto whole = GroundPointsOf(PlanAmongHouses(GetParam()));
  for (const double west : {3, 45}) {
    const Plan plan = PlanAmongHouses(GetParam(), {{{{west, 50}, {west + 30, 50}, {west + 30, 70}, {west, 70}}}});
    ASSERT_FALSE(plan.holes.empty());
    for (const PlannedHole& hole : plan.holes) EXPECT_FALSE(hole.ground_points.empty());
    const auto points = GroundPointsOf(plan);
    EXPECT_TRUE(std::includes(whole.begin(), whole.end(), points.begin(), points.end()));
    const auto is_far = [&](const std::array<double, 3>& p) { return p[0] > west + 40; };
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), is_far));
  }
}

// The surface ends 10 m inside the cells, and the area reaches over its western end.
TEST_P(GroundPointsTest, BeyondTheEndOfTheSurfaceAnAreaHasThoseOfItsOwnShore) {
  SceneMakerOptions options =
      HoleOverNineCells(GetParam(), [](double, double x, double y) { return Ground(x, y) + (InHouse(y) ? 9 : 0); });
  options.ellipses = {};
  options.boxes = {{{-1, -1}, {10, 121}}, {{110, -1}, {121, 121}}, {{-1, -1}, {121, 10}}, {{-1, 110}, {121, 121}}};
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  PlanInput input = scene.Input();
  input.area.rings = {{{2, 42}, {30, 42}, {30, 78}, {2, 78}}};
  const auto points = GroundPointsOf(MakePlan(input, {}));
  EXPECT_FALSE(points.empty());
  for (const auto& p : points) EXPECT_TRUE(p[1] > 38 && p[1] < 82) << p[1];
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
