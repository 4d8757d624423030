#include "coordinator/plan/water/mark_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

// East of the hole, 12 m wide along the shore and 9 m high.
bool InHouse(double x, double y) { return x > 105 && std::abs(y - 59) < 6; }

double Gentle(double x, double y) { return 0.05 * x + 0.5 * std::sin(y / 15); }

Plan PlanOf(const SceneMakerOptions& scene) { return MakePlan(SurveyScene(MakeScene(scene)).Input(), {}); }

class MarkObjectsTest : public ::testing::TestWithParam<Cut> {};

TEST_P(MarkObjectsTest, RimVerticesOnAHouseAreMarkedAndNoOthers) {
  const Plan plan = PlanOf(
      HoleOverNineCells(GetParam(), [](double, double x, double y) { return Gentle(x, y) + (InHouse(x, y) ? 9 : 0); }));
  int on_house = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      const PlanVertex& v = plan.vertices[s.from];
      if (v.index < 0) continue;
      const bool high = v.position.z() - Gentle(v.position.x(), v.position.y()) > 4;
      EXPECT_EQ(v.on_object, high) << v.position.transpose();
      on_house += high;
    }
  }
  EXPECT_GT(on_house, 3);
}

// One house, and a row of them on both shores.
TEST_P(MarkObjectsTest, AHoleAmongManyObjectsIsSaidToBe) {
  const auto among = [&](const auto& is_house) {
    const Plan plan = PlanOf(HoleOverNineCells(
        GetParam(), [&](double, double x, double y) { return Gentle(x, y) + (is_house(x, y) ? 9 : 0); }));
    return std::all_of(plan.holes.begin(), plan.holes.end(), [](const PlannedHole& h) { return h.among_objects; });
  };
  EXPECT_FALSE(among(InHouse));
  EXPECT_TRUE(among([](double, double y) { return std::fmod(y, 24) < 10; }));
}

// A roof 40 m wide is ground to an opening; its walls are 20 m high.
TEST_P(MarkObjectsTest, ARoofThatWallsLiftIsMarked) {
  const auto on_roof = [](double x, double y) { return x > 90 && std::abs(y - 59) < 20; };
  const Plan plan = PlanOf(HoleOverNineCells(
      GetParam(), [&](double, double x, double y) { return Gentle(x, y) + (on_roof(x, y) ? 20 : 0); }));
  int marked = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      const PlanVertex& v = plan.vertices[s.from];
      if (v.index < 0) continue;
      const bool on_wall = v.position.z() > 6 && v.position.z() < 20;
      EXPECT_TRUE(on_wall || v.on_object == (v.position.z() > 6)) << v.position.transpose();
      marked += v.on_object;
    }
  }
  EXPECT_GT(marked, 10);
}

// A river through the area. Its northern bank goes up behind towers, to a terrace and then to a roof at the edge of the
// area: by steps that are no walls. The street across tells.
TEST_P(MarkObjectsTest, ARoofUpToTheEdgeOfTheAreaIsMarkedAndATerrace) {
  const auto over_street = [](double x, double y) {
    if (y < 60 || x < 40) return 0.0;
    if (x < 46 || (x > 80 && x < 86)) return 30.0;
    return x < 80 ? 8.0 : 20.0;
  };
  SceneMakerOptions scene =
      HoleOverNineCells(GetParam(), [&](double, double x, double y) { return Gentle(x, 0) + over_street(x, y); });
  scene.ellipses = {};
  scene.strips = {{{{-10, 60}, {130, 60}}, 15}};
  const Plan plan = PlanOf(scene);
  int wrong = 0, terrace = 0, roof = 0;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      const PlanVertex& v = plan.vertices[s.from];
      if (v.index < 0 || s.seam) continue;
      const double height = v.position.z() - Gentle(v.position.x(), 0);
      wrong += v.on_object != (height > 4);
      terrace += v.on_object && height > 7 && height < 9;
      roof += v.on_object && v.position.x() > 90;
    }
  }
  EXPECT_LE(wrong, 4) << "on the towers' walls";
  EXPECT_GE(terrace, 12);
  EXPECT_GE(roof, 12);
}

TEST_P(MarkObjectsTest, OnRoughGroundNothingStands) {
  const Plan plan = PlanOf(
      HoleOverNineCells(GetParam(), [](double, double x, double y) { return 8 * std::sin(x / 4) * std::cos(y / 5); }));
  for (const PlanVertex& v : plan.vertices) EXPECT_FALSE(v.on_object);
}

// Whether something stands at each original vertex on the rims of a plan, by place.
std::map<std::array<double, 3>, bool> MarksOf(const Plan& plan) {
  std::map<std::array<double, 3>, bool> marks;
  for (const PlannedHole& hole : plan.holes) {
    for (const RimSegment& s : hole.segments) {
      const PlanVertex& v = plan.vertices[s.from];
      if (v.index >= 0) marks[{v.position.x(), v.position.y(), v.position.z()}] = v.on_object;
    }
  }
  return marks;
}

// Inside the area nothing leads down from the roof.
TEST_P(MarkObjectsTest, ARoofThatAnAreaCutsOutIsWhatItIsInTheScene) {
  const auto on_roof = [](double x, double y) { return x > 90 && std::abs(y - 59) < 20; };
  const SurveyedScene scene = SurveyScene(MakeScene(HoleOverNineCells(
      GetParam(), [&](double, double x, double y) { return Gentle(x, y) + (on_roof(x, y) ? 20 : 0); })));
  PlanInput input = scene.Input();
  const auto whole = MarksOf(MakePlan(input, {}));
  input.area.rings = {{{80, 44}, {118, 44}, {118, 74}, {80, 74}}};
  const Plan plan = MakePlan(input, {});
  int marked = 0;
  for (const auto& [place, mark] : MarksOf(plan)) {
    const auto known = whole.find(place);
    if (known == whole.end()) continue;  // a crossing with the area's edge
    EXPECT_EQ(mark, known->second) << place[0] << ' ' << place[1];
    marked += mark;
  }
  EXPECT_GT(marked, 10);
  for (const PlannedHole& hole : plan.holes) EXPECT_TRUE(hole.among_objects);
}

// The house alone, or no shore at all: the surface has the ground of the whole shore to go by.
TEST_P(MarkObjectsTest, WhereAnAreaLeavesNoGroundTheHoleIsAmongObjects) {
  const SurveyedScene scene = SurveyScene(MakeScene(HoleOverNineCells(
      GetParam(), [](double, double x, double y) { return Gentle(x, y) + (InHouse(x, y) ? 9 : 0); })));
  PlanInput input = scene.Input();
  const auto among = [&](double west, double south, double east, double north) {
    input.area.rings = {{{west, south}, {east, south}, {east, north}, {west, north}}};
    const Plan plan = MakePlan(input, {});
    EXPECT_FALSE(plan.holes.empty());
    return std::all_of(plan.holes.begin(), plan.holes.end(), [](const PlannedHole& h) { return h.among_objects; });
  };
  EXPECT_TRUE(among(85, 57, 118, 61));
  EXPECT_TRUE(among(50, 50, 70, 70));
  EXPECT_FALSE(among(50, 30, 118, 90));
}

TEST(MarkObjectsOfSceneTest, OfWhatIsKnownItStays) {
  const SurveyedScene scene = SurveyScene(MakeScene(HoleOverNineCells(
      Cut::kClipped, [](double, double x, double y) { return Gentle(x, y) + (InHouse(x, y) ? 9 : 0); })));
  Plan plan = MakePlan(scene.Input(), {});
  const auto house =
      std::find_if(plan.vertices.begin(), plan.vertices.end(), [](const auto& v) { return v.on_object; });
  ASSERT_NE(house, plan.vertices.end());
  const auto at = house - plan.vertices.begin();
  KnownObjects known;
  known.on_object.resize(plan.vertices.size());
  known.on_object[at] = false;
  MarkObjects(scene.Input(), known, plan);
  EXPECT_FALSE(plan.vertices[at].on_object);
}

TEST(MarkObjectsOfSceneTest, AGroupIsAmongObjectsAsItsShoreIsIfAllOfItIsKnown) {
  const SurveyedScene scene = SurveyScene(MakeScene(HoleOverNineCells(
      Cut::kClipped, [](double, double x, double y) { return Gentle(x, y) + (InHouse(x, y) ? 9 : 0); })));
  Plan plan = MakePlan(scene.Input(), {});
  KnownObjects known{false,
                     std::vector<std::optional<bool>>(plan.vertices.size(), false),
                     {{true, {{0, 0, 0}}}},
                     std::vector<int32_t>(plan.holes.size(), 0)};
  const auto among = [&] {
    MarkObjects(scene.Input(), known, plan);
    return std::ranges::any_of(plan.holes, [](const PlannedHole& h) { return h.among_objects; });
  };
  EXPECT_TRUE(among());
  known.shores[0].among_objects = false;
  EXPECT_FALSE(among());
  known.shores[0].among_objects = true;
  known.shore_of.back() = -1;
  EXPECT_FALSE(among());
}

// What an area leaves of the rims may be too little to tell walls from rough ground by.
TEST(MarkObjectsOfSceneTest, WhereSomethingStandsInTheSceneItMayInTheArea) {
  const SurveyedScene scene = SurveyScene(MakeScene(HoleOverNineCells(
      Cut::kClipped, [](double, double x, double y) { return 8 * std::sin(x / 4) * std::cos(y / 5); })));
  Plan plan = MakePlan(scene.Input(), {});
  KnownObjects known;
  const auto marked = [&] {
    MarkObjects(scene.Input(), known, plan);
    return std::any_of(plan.vertices.begin(), plan.vertices.end(), [](const PlanVertex& v) { return v.on_object; });
  };
  EXPECT_FALSE(marked());
  known.any = true;
  EXPECT_TRUE(marked());
}

INSTANTIATE_TEST_SUITE_P(Cuts, MarkObjectsTest, ::testing::Values(Cut::kClipped, Cut::kRagged, Cut::kOverlap),
                         [](const auto& cut) { return NameOf(cut.param); });

}  // namespace
}  // namespace tilemend
