#include "coordinator/plan/overlap/picture_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr CellId kCell{0, 0};

// A tile with an edge from (0, 0) to (4, 0) and one from (2, -2) to (2, 2), which cross at (2, 0); in the plan its
// vertices have the numbers 10 to 13, and the crossing 14. A hole lies to the right of both.
struct CrossingEdges {
  JointTiles joint;
  Plan plan;
  PlannedHole hole;
  const std::vector<int32_t> numbers = {10, 11, 12, 13, 14};

  CrossingEdges() {
    auto record = std::make_shared<SurveyRecord>();
    plan.vertices.resize(10);
    for (const Point3& p : {Point3(0, 0, 0), Point3(4, 0, 0), Point3(2, -2, 0), Point3(2, 2, 0), Point3(2, 0, 0)}) {
      plan.vertices.emplace_back().position = p;
      if (record->vertices.size() < 4) record->vertices.emplace_back().position = p;
    }
    record->edges = {{0, 1}, {2, 3}};
    joint.own[kCell] = std::move(record);
    joint.edges_through[kCell] = {{0, 1}};
    joint.chain[kCell] = {true, true};
    joint.squares[kCell].side = {0, 4, -2, 2};
    hole.segments = {{11, 14, false}, {14, 12, false}, {12, 11, true}};
  }

  PictureEdges Edges() const { return {joint, kCell, numbers}; }
};

TEST(PictureEdgesTest, TellsWhereAHolePassesFromOneEdgeToAnother) {
  const CrossingEdges scene;
  const std::vector<ChainPassage> passages = scene.Edges().PassagesOf(scene.plan, scene.hole);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_EQ(passages[0].arriving->edge, 1);
  EXPECT_EQ(passages[0].leaving->edge, 0);
  EXPECT_EQ(passages[0].arriving->place, Point2(2, 0));
  EXPECT_EQ(passages[0].leaving->place, Point2(2, 0));
  EXPECT_FALSE(passages[0].at_outline);
}

TEST(PictureEdgesTest, AHoleThatGoesOnAlongAnEdgePassesToNone) {
  CrossingEdges scene;
  scene.hole.segments = {{11, 14, false}, {14, 10, false}, {10, 11, true}};
  EXPECT_THAT(scene.Edges().PassagesOf(scene.plan, scene.hole), IsEmpty());
}

// The second edge is on the outline of a piece, which ends at the grid line, where another tile's vertex 15 lies.
TEST(PictureEdgesTest, TellsWhereAWayAlongAnOutlineComesToTheGridLine) {
  CrossingEdges scene;
  scene.joint.chain[kCell] = {true, false};
  scene.plan.vertices.emplace_back().position = Point3(5, -2, 0);
  scene.hole.segments = {{11, 14, false}, {14, 12, false}, {12, 15, false}};
  const std::vector<ChainPassage> passages = scene.Edges().PassagesOf(scene.plan, scene.hole);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_FALSE(passages[0].arriving);
  EXPECT_EQ(passages[0].leaving->edge, 0);
  EXPECT_EQ(passages[0].leaving->place, Point2(2, 0));
  EXPECT_EQ(passages[0].at_outline, Point2(2, -2));
}

TEST(PictureEdgesTest, TellsWhereAWayAlongAnOutlineComesFromTheGridLine) {
  CrossingEdges scene;
  scene.joint.chain[kCell] = {false, true};
  scene.plan.vertices.emplace_back().position = Point3(4, -2, 0);
  scene.hole.segments = {{15, 11, false}, {11, 14, false}, {14, 12, false}};
  const std::vector<ChainPassage> passages = scene.Edges().PassagesOf(scene.plan, scene.hole);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_FALSE(passages[0].leaving);
  EXPECT_EQ(passages[0].arriving->edge, 1);
  EXPECT_EQ(passages[0].arriving->place, Point2(2, 0));
  EXPECT_EQ(passages[0].at_outline, Point2(4, 0));
}

TEST(PictureEdgesTest, ASeamIsNoEdge) {
  CrossingEdges scene;
  scene.hole.segments[1].seam = true;
  EXPECT_THAT(scene.Edges().PassagesOf(scene.plan, scene.hole), IsEmpty());
}

TEST(PictureEdgesTest, TellsWholeEdgesAndThoseAtTheEndsOfParts) {
  const CrossingEdges scene;
  const PictureEdges edges = scene.Edges();
  EXPECT_TRUE(edges.IsOwn(13));
  EXPECT_FALSE(edges.IsOwn(14));
  EXPECT_EQ(edges.Whole({11, 10, false}), 0);
  EXPECT_EQ(edges.Whole({10, 11, false}), std::nullopt) << "the other way round";
  EXPECT_THAT(edges.AtEnds({11, 14, false}), ElementsAre(0, 1));
  EXPECT_THAT(edges.AtEnds({11, 10, false}), IsEmpty());
}

}  // namespace
}  // namespace tilemend
