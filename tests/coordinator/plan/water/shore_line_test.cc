#include "coordinator/plan/water/shore_line.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// A hole with four vertices: two of a tile, one of them on an object, and two new ones. Its own region leaves one out.
Plan PlanOfAHole() {
  Plan plan;
  for (int i = 0; i < 4; ++i) {
    PlanVertex v;
    v.index = i < 2 ? i : -1;
    v.position = Point3(i, 2 * i, 3 * i);
    v.on_object = i == 1;
    plan.vertices.push_back(v);
  }
  PlannedHole hole;
  hole.segments = {{3, 0}, {0, 1}, {1, 2}, {2, 3, true}};
  hole.own_regions = {{{0, 1}, {1, 0, true}}};
  plan.holes = {hole};
  return plan;
}

TEST(ShoreLineTest, HasRimsAndNoSeams) {
  const ShoreLine line = ShoreLineOf(PlanOfAHole(), {0});
  EXPECT_EQ(line.vertices, (std::vector<int32_t>{3, 0, 1, 2}));
  EXPECT_EQ(line.points[2], Point3(1, 2, 3));
  EXPECT_EQ(line.kinds,
            (std::vector<ShorePoint>{ShorePoint::kOther, ShorePoint::kGround, ShorePoint::kOther, ShorePoint::kOther}));
  ASSERT_EQ(line.edges.size(), 3u);
  EXPECT_EQ(line.edges[1].from, 1);
  EXPECT_EQ(line.edges[1].to, 2);
}

TEST(ShoreLineTest, TheWholeOneHasThoseOfOwnRegionsAsWell) {
  const ShoreLine line = WholeShoreLineOf(PlanOfAHole(), {0});
  EXPECT_EQ(line.points.size(), 4u);
  EXPECT_EQ(line.edges.size(), 4u);
}

TEST(ShoreLineTest, GroundIsLinkedAlongEdgesAndOverObjects) {
  const std::vector<Point3> points = {{0, 0, 5}, {1, 0, 9}, {2, 0, 9}, {3, 0, 4}, {4, 0, 4}};
  const auto o = ShorePoint::kOther, g = ShorePoint::kGround;
  const std::vector<ShorePoint> kinds = {g, o, o, g, g};
  const std::vector<DirectedEdge> edges = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
  const std::vector<std::vector<int32_t>> objects = GroundBesideObjects(points, kinds, edges);
  EXPECT_EQ(objects, (std::vector<std::vector<int32_t>>{{3, 0}}));
  const std::vector<GroundLink> links = LinkGround(kinds, edges, objects);
  ASSERT_EQ(links.size(), 2u);
  EXPECT_EQ(links[0].a, 3);
  EXPECT_EQ(links[0].b, 4);
  EXPECT_FALSE(links[0].over_object);
  EXPECT_EQ(links[1].a, 3);
  EXPECT_EQ(links[1].b, 0);
  EXPECT_TRUE(links[1].over_object);
}

}  // namespace
}  // namespace tilemend
