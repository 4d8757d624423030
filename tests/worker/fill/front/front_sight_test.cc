#include "worker/fill/front/front_sight.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

class FrontSightTest : public testing::Test {
 protected:
  bool IsClear(const Point3& p) const {
    return sight_.IsClear({points_[0], points_[1], p}, {0, 1, -1}, Eigen::Vector3d::UnitZ());
  }

  // A square with a tooth that points down to (2, 1).
  const std::vector<Point3> points_ = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(4, 4, 0), Point3(2, 1, 0),
                                       Point3(0, 4, 0)};
  const FrontLoops loops_{std::vector<std::vector<int32_t>>{{0, 1, 2, 3, 4}}};
  const FrontSight sight_{loops_, points_};
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

TEST_F(FrontSightTest, DistancesLeaveOutTheEdgesOfTheCorner) {
  EXPECT_DOUBLE_EQ(sight_.DistanceTo(Point3(2, 0.5, 0), 0), 0.5);
  EXPECT_DOUBLE_EQ(sight_.DistanceTo(Point3(2, 0.75, 0), 3), 0.75);
}

}  // namespace
}  // namespace tilemend
