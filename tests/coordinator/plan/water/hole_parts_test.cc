#include "coordinator/plan/water/hole_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "coordinator/plan/water/mark_objects.h"

namespace tilemend {
namespace {

constexpr double kStreet = 2;
constexpr double kRoof = 30;

using Corners = std::vector<Point2>;
using HeightOf = std::function<double(const Point2&)>;

// A hole whose rim has a vertex each 2 m; what is higher than the street stands on objects.
Plan PlanOf(const Corners& corners, const HeightOf& height) {
  Plan plan;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Point2 way = corners[(i + 1) % corners.size()] - corners[i];
    const int steps = std::max(1, static_cast<int>(std::round(way.norm() / 2)));
    for (int k = 0; k < steps; ++k) {
      const Point2 p = corners[i] + way * k / steps;
      PlanVertex vertex;
      vertex.index = static_cast<int32_t>(plan.vertices.size());
      vertex.position = {p.x(), p.y(), height(p)};
      vertex.on_object = vertex.position.z() > kStreet + 1;
      if (vertex.on_object) vertex.ground = static_cast<float>(kStreet);
      plan.vertices.push_back(vertex);
    }
  }
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

// Seen from above a room of 20 x 20 m, and south of it a street of 40 x 10 m. A gap in the wall of 1 m between them
// joins them.
Corners RoomAndStreet(double gap = 1) {
  const double west = 20 - gap / 2;
  const double east = 20 + gap / 2;
  return {{0, 0},   {40, 0},  {40, 10}, {east, 10}, {east, 11}, {30, 11},
          {30, 31}, {10, 31}, {10, 11}, {west, 11}, {west, 10}, {0, 10}};
}

bool IsOfRoom(const Point3& p) { return p.y() > 10.5; }

HeightOf Roofed(HeightOf room = [](const Point2&) { return kRoof; }) {
  return [room](const Point2& p) { return p.y() <= 10 ? kStreet : room(p); };
}

bool IsInStreetAlone(const Plan& plan) {
  const RoofParts parts = FindRoofParts(plan, {0});
  return parts.joined.empty() && parts.below.empty();
}

std::set<int32_t> RoomOf(const Plan& plan) {
  std::set<int32_t> room;
  for (size_t v = 0; v < plan.vertices.size(); ++v) {
    if (IsOfRoom(plan.vertices[v].position)) room.insert(static_cast<int32_t>(v));
  }
  return room;
}

std::set<int32_t> Joined(const Plan& plan, const std::vector<int32_t>& holes = {0}) {
  const RoofParts parts = FindRoofParts(plan, holes);
  return {parts.joined.begin(), parts.joined.end()};
}

TEST(FindRoofPartsTest, ThePartBehindANarrowGapIsOne) {
  const Plan plan = PlanOf(RoomAndStreet(), Roofed());
  EXPECT_EQ(Joined(plan), RoomOf(plan));
  EXPECT_TRUE(FindRoofParts(plan, {0}).below.empty());
}

TEST(FindRoofPartsTest, ThroughAWideGapTheStreetGoesOn) {
  EXPECT_TRUE(IsInStreetAlone(PlanOf(RoomAndStreet(4), Roofed())));
}

// Ground in the west, on a quarter of the yard's rim.
TEST(FindRoofPartsTest, TreesAroundAYardAreNoRoof) {
  const auto crowns = [](const Point2& p) {
    return p.x() < 10.5 ? kStreet : kStreet + 6 + 4 * std::sin((p.x() + 1.3 * p.y()) / 2);
  };
  EXPECT_TRUE(IsInStreetAlone(PlanOf(RoomAndStreet(), Roofed(crowns))));
  const auto roof = [](const Point2& p) { return p.x() < 10.5 ? kStreet : kRoof; };
  EXPECT_FALSE(IsInStreetAlone(PlanOf(RoomAndStreet(), Roofed(roof))));
}

// The roof goes over pieces of the street, and keeps its height there.
TEST(FindRoofPartsTest, GroundOnTheRimOfARoofIsBelowIt) {
  const auto roof = [](const Point2& p) { return p.x() < 10.5 ? kStreet : kRoof; };
  const Plan plan = PlanOf(RoomAndStreet(), Roofed(roof));
  const RoofParts parts = FindRoofParts(plan, {0});
  EXPECT_GT(parts.below.size(), 8u);
  for (const auto& [v, height] : parts.below) {
    EXPECT_LT(plan.vertices[v].position.x(), 10.5);
    EXPECT_EQ(height, static_cast<float>(kRoof));
  }
}

TEST(FindRoofPartsTest, AHouseAtOneSideOfAYardIsNotAroundIt) {
  const auto house_in_east = [](const Point2& p) { return p.x() > 29.5 || p.y() <= 11.5 ? kRoof : kStreet; };
  EXPECT_TRUE(IsInStreetAlone(PlanOf(RoomAndStreet(), Roofed(house_in_east))));
}

TEST(FindRoofPartsTest, WithoutObjectsNoneIs) {
  EXPECT_TRUE(IsInStreetAlone(PlanOf(RoomAndStreet(), [](const Point2&) { return kStreet; })));
}

// It does not fall apart, though walls to the roofs are a tenth of those to the ground.
TEST(FindRoofPartsTest, AStreetBetweenRoofsIsNone) {
  const auto canyon = [](const Point2& p) { return p.x() < 1 || p.x() > 99 ? kStreet : kRoof; };
  EXPECT_TRUE(IsInStreetAlone(PlanOf({{0, 0}, {100, 0}, {100, 10}, {0, 10}}, canyon)));
}

// 2.6 x 2.2 m, behind 1.2 m.
TEST(FindRoofPartsTest, ANicheOfAFacadeIsNone) {
  const Corners niche = {{0, 0},       {40, 0},      {40, 10},     {20.6, 10},   {20.6, 10.5}, {21.3, 10.5},
                         {21.3, 12.7}, {18.7, 12.7}, {18.7, 10.5}, {19.4, 10.5}, {19.4, 10},   {0, 10}};
  const auto facade = [](const Point2& p) { return p.y() < 9.9 || p.x() < 1 || p.x() > 39 ? kStreet : kRoof; };
  EXPECT_TRUE(IsInStreetAlone(PlanOf(niche, facade)));
}

TEST(FindRoofPartsTest, AllHeightsMayBeMovedAndGroundUnknown) {
  for (const double shift : {-kRoof, 0.0, 1000.0}) {
    Plan plan = PlanOf(RoomAndStreet(), Roofed());
    for (PlanVertex& v : plan.vertices) {
      v.position.z() += shift;
      v.ground.reset();
    }
    EXPECT_EQ(Joined(plan), RoomOf(plan)) << shift;
  }
}

// A seam between two holes of a group, across all of the region that it meets.
void AddSeam(const std::vector<std::pair<Point2, Point2>>& pieces, Plan& plan) {
  plan.holes.emplace_back();
  for (const auto& [a, b] : pieces) {
    RimSegment seam;
    seam.seam = true;
    seam.from = static_cast<int32_t>(plan.vertices.size());
    seam.to = seam.from + 1;
    for (const Point2& p : {a, b}) {
      PlanVertex vertex;
      vertex.position = {p.x(), p.y(), 0};
      plan.vertices.push_back(vertex);
    }
    for (PlannedHole& hole : plan.holes) hole.segments.push_back(seam);
  }
}

TEST(FindRoofPartsTest, SeamsPartNothing) {
  const Plan whole = PlanOf(RoomAndStreet(), Roofed());
  Plan north_south = whole;
  AddSeam({{{26, 0}, {26, 10}}, {{26, 11}, {26, 31}}}, north_south);
  EXPECT_EQ(Joined(north_south, {0, 1}), Joined(whole));
  Plan through_gap = whole;
  AddSeam({{{20, 0}, {20, 31}}}, through_gap);
  EXPECT_EQ(Joined(through_gap, {0, 1}), Joined(whole));
  Plan east_west = whole;
  AddSeam({{{10, 20}, {30, 20}}}, east_west);
  EXPECT_EQ(Joined(east_west, {0, 1}), Joined(whole));
}

// Ground at the two ends alone; a seam at each third must not leave a middle without ground.
TEST(FindRoofPartsTest, SeamsMakeNoRoofOfAStreet) {
  const auto canyon = [](const Point2& p) { return p.x() < 1 || p.x() > 99 ? kStreet : kRoof; };
  Plan plan = PlanOf({{0, 0}, {100, 0}, {100, 10}, {0, 10}}, canyon);
  AddSeam({{{34, 0}, {34, 10}}, {{66, 0}, {66, 10}}}, plan);
  EXPECT_TRUE(Joined(plan, {0, 1}).empty());
}

// What the fill is told: it joins the roof, and passes above the street on the roof's rim.
TEST(FindRoofPartsTest, MarkObjectsTakesThem) {
  const auto roof = [](const Point2& p) { return p.x() < 10.5 ? kStreet : kRoof; };
  const Plan plan = PlanOf(RoomAndStreet(), Roofed(roof));
  const RoofParts parts = FindRoofParts(plan, {0});
  Plan marked = plan;
  marked.holes[0].kind = HoleKind::kOpenI;
  marked.holes[0].cluster = 0;
  MarkObjects(marked);
  for (const int32_t v : parts.joined) {
    EXPECT_FALSE(marked.vertices[v].on_object) << v;
    EXPECT_FALSE(marked.vertices[v].ground.has_value()) << v;
  }
  for (const auto& [v, height] : parts.below) {
    EXPECT_FALSE(plan.vertices[v].on_object) << v;
    EXPECT_TRUE(marked.vertices[v].on_object) << v;
    EXPECT_EQ(marked.vertices[v].ground, height) << v;
  }
  EXPECT_FALSE(parts.joined.empty() || parts.below.empty());
}

TEST(FindRoofPartsTest, TheSameInASceneThatIsTurned) {
  const Plan plan = PlanOf(RoomAndStreet(), Roofed());
  Plan turned = plan;
  for (PlanVertex& v : turned.vertices) v.position = {-v.position.y(), v.position.x(), v.position.z()};
  EXPECT_EQ(Joined(turned), Joined(plan));
}

}  // namespace
}  // namespace tilemend
