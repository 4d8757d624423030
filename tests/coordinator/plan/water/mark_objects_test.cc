#include "coordinator/plan/water/mark_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

double Gentle(double x, double y) { return 0.05 * x + 0.5 * std::sin(y / 15); }

// East of the hole, 12 m wide along the shore.
bool InHouse(const Point3& p) { return p.x() > 105 && std::abs(p.y() - 59) < 6; }

// The plan of a hole over nine cells, with the boundary vertices flagged that the function says.
Plan PlanOf(Cut cut, const std::function<bool(const Point3&)>& on_object) {
  const SurveyedScene scene =
      SurveyScene(MakeScene(HoleOverNineCells(cut, [](double, double x, double y) { return Gentle(x, y); })));
  PlanInput input = scene.Input();
  for (const auto& [cell, record] : scene.records) {
    RimGround& rim = input.rim_ground[cell];
    for (const BoundaryVertex& v : record.vertices) {
      rim.on_object.push_back(on_object(v.position));
      rim.ground.push_back(0.5F);
    }
  }
  return MakePlan(input, {});
}

// By vertex of the rims. They are the plan's own.
std::vector<const PlanVertex*> OriginalRim(const Plan& plan) {
  std::vector<const PlanVertex*> rim;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      if (plan.vertices[s.from].index >= 0) rim.push_back(&plan.vertices[s.from]);
    }
  }
  return rim;
}

std::vector<const PlanVertex*> OriginalRim(const Plan&&) = delete;

class MarkObjectsTest : public ::testing::TestWithParam<Cut> {};

TEST_P(MarkObjectsTest, FlaggedVerticesOfTheRimAreMarkedAndNoOthers) {
  int marked = 0;
  const Plan plan = PlanOf(GetParam(), InHouse);
  for (const PlanVertex* v : OriginalRim(plan)) {
    EXPECT_EQ(v->on_object, InHouse(v->position)) << v->position.transpose();
    EXPECT_EQ(v->ground.has_value(), v->on_object);
    marked += v->on_object;
  }
  EXPECT_GT(marked, 3);
}

// A hole in a roof goes on as the roof does.
TEST_P(MarkObjectsTest, WhereAllOfARimStandsOnObjectsNoneOfItDoes) {
  const Plan plan = PlanOf(GetParam(), [](const Point3&) { return true; });
  for (const PlanVertex* v : OriginalRim(plan)) {
    EXPECT_FALSE(v->on_object);
  }
}

TEST_P(MarkObjectsTest, WithoutFlagsNothingIsMarked) {
  const SurveyedScene scene =
      SurveyScene(MakeScene(HoleOverNineCells(GetParam(), [](double, double x, double y) { return Gentle(x, y); })));
  const Plan plan = MakePlan(scene.Input(), {});
  for (const PlanVertex* v : OriginalRim(plan)) EXPECT_FALSE(v->on_object);
}

// A closed hole of the middle cell.
Plan PlanOfClosed(const std::function<bool(const Point3&)>& on_object, bool is_filtered) {
  SceneMakerOptions options = HoleOverNineCells(Cut::kClipped, [](double, double x, double y) { return Gentle(x, y); });
  options.ellipses = {{{61, 59}, {15, 12}}};
  const SurveyedScene scene = SurveyScene(MakeScene(options));
  PlanInput input = scene.Input();
  for (const auto& [cell, record] : scene.records) {
    if (!is_filtered) break;
    RimGround& rim = input.rim_ground[cell];
    for (const BoundaryVertex& v : record.vertices) {
      rim.on_object.push_back(on_object(v.position));
      rim.ground.push_back(0.5F);
    }
  }
  return MakePlan(input, {});
}

TEST(HolesInGroundTest, AClosedHoleWithGroundOnItsRimIsOne) {
  const auto nowhere = [](const Point3&) { return false; };
  const auto everywhere = [](const Point3&) { return true; };
  const auto in_west = [](const Point3& p) { return p.x() < 55; };
  const auto is_in_ground = [](const Plan& plan) {
    EXPECT_EQ(plan.holes.size(), 1u);
    EXPECT_EQ(plan.holes[0].kind, HoleKind::kClosed);
    return plan.holes[0].standing == Standing::kInGround;
  };
  EXPECT_TRUE(is_in_ground(PlanOfClosed(nowhere, true)));
  EXPECT_TRUE(is_in_ground(PlanOfClosed(in_west, true)));
  EXPECT_FALSE(is_in_ground(PlanOfClosed(everywhere, true)));
  EXPECT_FALSE(is_in_ground(PlanOfClosed(nowhere, false)));
}

INSTANTIATE_TEST_SUITE_P(Cuts, MarkObjectsTest, ::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap));

}  // namespace
}  // namespace tilemend
