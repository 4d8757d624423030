#include "coordinator/plan/overlap/joint_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace tilemend {
namespace {

BoundaryVertex VertexAt(double x, double z) { return {0, Point3(x, 0, z), Eigen::Vector3d(0, 0, 1), z}; }

// An edge from ground at x = 0 up to a roof at x = 10, with a new vertex on it and one beside that no edge passes.
JointTiles Joint(double x, double z) {
  JointTiles joint;
  auto own = std::make_shared<SurveyRecord>();
  own->vertices = {VertexAt(0, 1), VertexAt(10, 11)};
  own->edges = {{0, 1, 0}};
  joint.own[{0, 0}] = own;
  SurveyRecord& record = joint.records[{0, 0}];
  record.vertices = own->vertices;
  record.vertices.push_back(VertexAt(x, z));
  record.vertices.push_back(VertexAt(11, 11));
  record.edges = {{0, 2, 0}, {2, 1, 0}, {1, 3, 0}};
  joint.edges_through[{0, 0}] = {{0}, {}};
  return joint;
}

RimGround Known(float a, float b) { return {{false, true}, {a, b}}; }

TEST(JointGroundTest, ANewVertexHasTheFlagOfTheNearerEndAndTheGroundBetween) {
  const RimGround near = JointGround(Joint(2, 3), {{{0, 0}, Known(1, 2)}}).at({0, 0});
  EXPECT_FALSE(near.on_object[2]);
  EXPECT_FLOAT_EQ(near.ground[2], 1.2F);
  const RimGround far = JointGround(Joint(8, 9), {{{0, 0}, Known(1, 2)}}).at({0, 0});
  EXPECT_TRUE(far.on_object[2]);
  EXPECT_FLOAT_EQ(far.ground[2], 1.8F);
}

TEST(JointGroundTest, TheOwnVerticesKeepTheirs) {
  const RimGround rim = JointGround(Joint(2, 3), {{{0, 0}, Known(1, 2)}}).at({0, 0});
  EXPECT_FALSE(rim.on_object[0]);
  EXPECT_TRUE(rim.on_object[1]);
  EXPECT_EQ(rim.ground[1], 2);
}

TEST(JointGroundTest, TheGroundAroundHolesStays) {
  RimGround known = Known(1, 2);
  known.side = 3;
  known.around = {{4, 5, 6.5F}};
  const RimGround rim = JointGround(Joint(2, 3), {{{0, 0}, known}}).at({0, 0});
  EXPECT_EQ(rim.side, 3);
  EXPECT_EQ(rim.around, known.around);
}

TEST(JointGroundTest, WhereOneEndKnowsNoGroundTheOtherDoes) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(JointGround(Joint(8, 9), {{{0, 0}, Known(1, none)}}).at({0, 0}).ground[2], 1);
  EXPECT_TRUE(std::isnan(JointGround(Joint(8, 9), {{{0, 0}, Known(none, none)}}).at({0, 0}).ground[2]));
}

TEST(JointGroundTest, AVertexThatNoEdgePassesHasWhatItsNeighbourHas) {
  const RimGround rim = JointGround(Joint(2, 3), {{{0, 0}, Known(1, 2)}}).at({0, 0});
  EXPECT_TRUE(rim.on_object[3]);
  EXPECT_EQ(rim.ground[3], 2);
}

TEST(JointGroundTest, TilesOfWhichNothingIsKnownAreNotThere) { EXPECT_TRUE(JointGround(Joint(2, 3), {}).empty()); }

}  // namespace
}  // namespace tilemend
