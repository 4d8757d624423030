#include "coordinator/plan/water/known_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr CellId kCell{2, 1};

// Adds a closed hole that is the square [x, x + 10) x [0, 10), with the next four vertices of its tile around.
PlannedHole& AddSquare(double x, Plan& plan) {
  PlannedHole& hole = plan.holes.emplace_back();
  hole.cell = kCell;
  const auto first = static_cast<int32_t>(plan.vertices.size());
  for (const Point2& p : {Point2(x, 0), Point2(x + 10, 0), Point2(x + 10, 10), Point2(x, 10)}) {
    PlanVertex& vertex = plan.vertices.emplace_back();
    vertex.tile = kCell;
    vertex.index = static_cast<int32_t>(plan.vertices.size()) - 1;
    vertex.position = {p.x(), p.y(), x};
  }
  for (int32_t k = 0; k < 4; ++k) hole.segments.push_back({first + k, first + (k + 1) % 4, false});
  return hole;
}

// Squares at 0, 20 and 40 m. Of the second one corner stands on an object.
Plan ThreeSquares() {
  Plan plan;
  for (const double x : {0, 20, 40}) AddSquare(x, plan);
  plan.vertices[5].on_object = true;
  plan.holes[1].among_objects = true;
  return plan;
}

TEST(FindKnownObjectsTest, VerticesAreWhatTheyAreInTheScene) {
  Plan part;
  AddSquare(20, part);
  EXPECT_THAT(FindKnownObjects(ThreeSquares(), part).on_object, ElementsAre(false, true, false, false));
}

TEST(FindKnownObjectsTest, OfVerticesOnNoRimOfTheSceneNothingIsKnown) {
  Plan whole = ThreeSquares(), part;
  AddSquare(20, part);
  part.vertices[0].position.x() += 0.1;
  part.vertices[2].index = -1;
  const std::optional<bool> none;
  EXPECT_THAT(FindKnownObjects(whole, part).on_object, ElementsAre(none, true, none, false));
  whole.holes[1].failure = "it crosses itself";
  EXPECT_THAT(FindKnownObjects(whole, part).on_object, ElementsAre(none, none, none, none));
}

TEST(FindKnownObjectsTest, AHoleIsAPartOfTheShoreAroundIt) {
  Plan part;
  for (const double x : {22, 60}) AddSquare(x, part);
  const KnownObjects known = FindKnownObjects(ThreeSquares(), part);
  ASSERT_THAT(known.shore_of, ElementsAre(1, -1));
  const KnownShore* shore = known.ShoreOf({1, 0});
  ASSERT_NE(shore, nullptr);
  EXPECT_TRUE(shore->among_objects);
  EXPECT_THAT(shore->ground, ElementsAre(Point3(20, 0, 20), Point3(30, 10, 20), Point3(20, 10, 20)));
  EXPECT_EQ(known.ShoreOf({1}), nullptr);
  EXPECT_EQ(KnownObjects().ShoreOf({0}), nullptr);
}

TEST(FindKnownObjectsTest, AroundWaterIsNoGround) {
  Plan whole = ThreeSquares(), part;
  whole.holes[1].water = 0;
  AddSquare(20, part);
  const KnownObjects known = FindKnownObjects(whole, part);
  EXPECT_THAT(known.shore_of, ElementsAre(-1));
  EXPECT_THAT(known.on_object, ElementsAre(false, true, false, false));
}

TEST(FindKnownObjectsTest, SaysWhetherSomethingStandsAnywhere) {
  Plan whole = ThreeSquares();
  EXPECT_TRUE(FindKnownObjects(whole, {}).any);
  whole.vertices[5].on_object = false;
  EXPECT_FALSE(FindKnownObjects(whole, {}).any);
}

TEST(KnownObjectsTest, ForgetsHolesAndTheirRimsButWhatOthersShare) {
  Plan plan = ThreeSquares();
  KnownObjects known = FindKnownObjects(plan, plan);
  plan.holes[2].segments[0].from = 6;  // a corner of the second one
  known.Forget(plan, {});
  EXPECT_THAT(known.shore_of, ElementsAre(0, 1, 2));
  known.Forget(plan, {1});
  EXPECT_THAT(known.shore_of, ElementsAre(0, -1, 2));
  for (size_t v = 0; v < 12; ++v) EXPECT_EQ(known.on_object[v].has_value(), v < 4 || v == 6 || v > 7) << v;
}

}  // namespace
}  // namespace tilemend
