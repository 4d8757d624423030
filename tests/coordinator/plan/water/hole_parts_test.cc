#include "coordinator/plan/water/hole_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace tilemend {
namespace {

constexpr double kStreet = 2;
constexpr double kRoof = 30;

// Seen from above a room of 20 x 20 m, and south of it a street of 40 x 10 m. A gap in the wall between them, y from 10
// to 11, joins them. Its two sides stand on the object.
struct RoomAndStreet {
  double gap = 1;                                                                   // metres
  std::function<double(const Point2&)> room = [](const Point2&) { return kRoof; };  // the height of its rim
};

bool IsOfRoom(const Point3& p) { return p.y() > 10.5; }

void AddSide(const Point2& from, const Point2& to, const RoomAndStreet& scene, Plan& plan) {
  const int steps = std::max(1, static_cast<int>(std::round((to - from).norm() / 2)));
  for (int i = 0; i < steps; ++i) {
    const Point2 p = from + (to - from) * i / steps;
    PlanVertex vertex;
    vertex.index = static_cast<int32_t>(plan.vertices.size());
    const bool is_street = p.y() <= 10;
    vertex.position = {p.x(), p.y(), is_street ? kStreet : scene.room(p)};
    vertex.on_object = vertex.position.z() > kStreet + 1;
    if (vertex.on_object) vertex.ground = static_cast<float>(kStreet);
    plan.vertices.push_back(vertex);
  }
}

Plan PlanOf(const RoomAndStreet& scene) {
  const double west = 20 - scene.gap / 2;
  const double east = 20 + scene.gap / 2;
  const std::vector<Point2> corners = {{0, 0},   {40, 0},  {40, 10}, {east, 10}, {east, 11}, {30, 11},
                                       {30, 31}, {10, 31}, {10, 11}, {west, 11}, {west, 10}, {0, 10}};
  Plan plan;
  for (size_t i = 0; i < corners.size(); ++i) AddSide(corners[i], corners[(i + 1) % corners.size()], scene, plan);
  PlannedHole hole;
  const auto n = static_cast<int32_t>(plan.vertices.size());
  for (int32_t v = 0; v < n; ++v) {
    RimSegment segment;
    segment.from = v;
    segment.to = (v + 1) % n;
    hole.segments.push_back(segment);
  }
  plan.holes.push_back(hole);
  return plan;
}

int CountOfRoom(const Plan& plan) {
  return static_cast<int>(
      std::ranges::count_if(plan.vertices, [](const PlanVertex& v) { return IsOfRoom(v.position); }));
}

bool IsNothingShutOff(const Plan& plan) {
  const ShutOff shut_off = VerticesShutOff(plan, {0});
  return shut_off.on_object.empty() && shut_off.below.empty();
}

TEST(VerticesShutOffTest, ThoseOfARoofBehindANarrowGapAre) {
  const Plan plan = PlanOf({});
  const ShutOff shut_off = VerticesShutOff(plan, {0});
  EXPECT_EQ(static_cast<int>(shut_off.on_object.size()), CountOfRoom(plan));
  EXPECT_TRUE(shut_off.below.empty());
  for (const int32_t v : shut_off.on_object) EXPECT_TRUE(IsOfRoom(plan.vertices[v].position)) << v;
}

TEST(VerticesShutOffTest, ThroughAWideGapTheStreetGoesOn) { EXPECT_TRUE(IsNothingShutOff(PlanOf({.gap = 4}))); }

// Ground in the west, on a quarter of the yard's rim.
TEST(VerticesShutOffTest, TreesAroundAYardAreNoRoof) {
  const auto crowns = [](const Point2& p) {
    return p.x() < 10.5 ? kStreet : kStreet + 6 + 4 * std::sin((p.x() + 1.3 * p.y()) / 2);
  };
  EXPECT_TRUE(IsNothingShutOff(PlanOf({.room = crowns})));
  const auto roof = [](const Point2& p) { return p.x() < 10.5 ? kStreet : kRoof; };
  EXPECT_FALSE(IsNothingShutOff(PlanOf({.room = roof})));
}

// The roof goes over pieces of the street, and keeps its height there.
TEST(VerticesShutOffTest, GroundOnTheRimOfARoofIsBelowIt) {
  const auto roof = [](const Point2& p) { return p.x() < 10.5 ? kStreet : kRoof; };
  const Plan plan = PlanOf({.room = roof});
  const ShutOff shut_off = VerticesShutOff(plan, {0});
  EXPECT_GT(shut_off.below.size(), 8u);
  for (const auto& [v, height] : shut_off.below) {
    EXPECT_LT(plan.vertices[v].position.x(), 10.5);
    EXPECT_EQ(height, static_cast<float>(kRoof));
  }
}

TEST(VerticesShutOffTest, AHouseAtOneSideOfAYardIsNotAroundIt) {
  const auto house_in_east = [](const Point2& p) { return p.x() > 29.5 || p.y() <= 11.5 ? kRoof : kStreet; };
  EXPECT_TRUE(IsNothingShutOff(PlanOf({.room = house_in_east})));
}

TEST(VerticesShutOffTest, WithoutObjectsNoneIs) {
  EXPECT_TRUE(IsNothingShutOff(PlanOf({.room = [](const Point2&) { return kStreet; }})));
}

}  // namespace
}  // namespace tilemend
