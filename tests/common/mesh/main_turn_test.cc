#include "common/mesh/main_turn.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

namespace tilemend {
namespace {

TEST(MainTurnTest, IsTheDirectionOfMostOfTheLength) {
  const Eigen::Rotation2Dd turn(-0.01);
  std::vector<Point2> ways = {turn * Point2(10, 0), turn * Point2(0, -7), {3, 4}};
  EXPECT_NEAR(MainTurn(ways, 0.7).value(), -0.01, 1e-12);
  EXPECT_FALSE(MainTurn(ways, 0.8).has_value());
  EXPECT_FALSE(MainTurn({}, 0.1).has_value());
  EXPECT_FALSE(MainTurn({{0, 0}}, 0.1).has_value());
}

}  // namespace
}  // namespace tilemend
