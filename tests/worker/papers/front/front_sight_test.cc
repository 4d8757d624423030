#include "worker/papers/front/front_sight.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

class FrontSightTest : public testing::Test {
 protected:
  FrontSightTest() {
    for (const int32_t node : loops_.Alive()) sight_.Follow(node, 1);
  }

  bool IsClear(const Point3& p) const {
    return sight_.IsClear({points_[0], points_[1], p}, {0, 1, -1}, Eigen::Vector3d::UnitZ());
  }

  // A square with a tooth that points down to (2, 1).
  const std::vector<Point3> points_ = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(4, 4, 0), Point3(2, 1, 0),
                                       Point3(0, 4, 0)};
  const FrontLoops loops_{std::vector<std::vector<int32_t>>{{0, 1, 2, 3, 4}}};
  FrontSight sight_{loops_, points_};
};

TEST_F(FrontSightTest, ATriangleMayCoverNoVertex) {
  EXPECT_TRUE(IsClear(Point3(2, 0.9, 0)));
  EXPECT_FALSE(IsClear(Point3(2, 1.5, 0)));
}

TEST_F(FrontSightTest, ATriangleMayCrossNoEdge) { EXPECT_FALSE(IsClear(Point3(-1, 2, 0))); }

TEST_F(FrontSightTest, WhatIsFarAboveOrBelowIsNotInTheWay) {
  for (const double height : {1.0, 5.0}) {
    const Point3 up(0, 0, height);
    EXPECT_EQ(sight_.IsClear({points_[0] + up, points_[1] + up, Point3(2, 1.5, height)}, {-1, -1, -1},
                             Eigen::Vector3d::UnitZ()),
              height > 4);
  }
}

TEST_F(FrontSightTest, ATriangleMayNotFaceBack) {
  EXPECT_FALSE(sight_.IsClear({points_[1], points_[0], Point3(2, 0.9, 0)}, {1, 0, -1}, Eigen::Vector3d::UnitZ()));
}

TEST_F(FrontSightTest, SteepEdgesCountAsFarAsTheTriangleReaches) {
  // From a corner of the square far up or down over the middle: where it passes over the triangle it is far above it.
  for (const double height : {2.0, 40.0}) {
    const std::vector<Point3> points = {Point3(-4, 2, 0), Point3(3, 1.5, height), Point3(-4, 9, height)};
    const FrontLoops loops(std::vector<std::vector<int32_t>>{{0, 1, 2}});
    FrontSight sight(loops, points);
    for (const int32_t node : loops.Alive()) sight.Follow(node, 1);
    const SpaceTriangle t = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(2, 3, 0)};
    EXPECT_EQ(sight.IsClear(t, {-1, -1, -1}, Eigen::Vector3d::UnitZ()), height > 4);
  }
}

TEST_F(FrontSightTest, NearnessLeavesOutTheEdgesOfTheCorner) {
  EXPECT_TRUE(sight_.IsNear(Point3(2, 0.5, 0), 0, 0.51));
  EXPECT_FALSE(sight_.IsNear(Point3(2, 0.5, 0), 0, 0.49));
  EXPECT_TRUE(sight_.IsNear(Point3(2, 0.75, 0), 3, 0.76));
  EXPECT_FALSE(sight_.IsNear(Point3(2, 0.75, 0), 3, 0.74));
}

TEST_F(FrontSightTest, NodesWithinADistanceAreFoundInOrder) {
  EXPECT_EQ(sight_.NodesNear(Point3(2, 0, 0), 2), (std::vector<int32_t>{0, 1, 3}));
  EXPECT_TRUE(sight_.NodesNear(Point3(2, -5, 0), 1).empty());
  EXPECT_GT(sight_.looked_at(), 0);
}

}  // namespace
}  // namespace tilemend
