#include "coordinator/plan/water/river.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/rims.h"

namespace tilemend {
namespace {

constexpr double kWidth = 6;

double Falling(double x, double) { return 10 - 0.004 * x; }

std::optional<FallingWater> RiverOf(const MadeRim& rim) {
  const std::vector<std::vector<PlaneSegment>> reaches = {rim.outline};
  const std::vector<Point2> axis = RiverAxis(reaches, kWidth);
  if (axis.size() < 2) return std::nullopt;
  return FindFall(axis, rim.chains, rim.outline, EvidenceOf(rim.chains, rim.outline));
}

TEST(FindFallTest, AReachThatFallsEvenlyIsARiver) {
  const auto river = RiverOf(BoxRim({0, -12}, {400, 12}, Falling));
  ASSERT_TRUE(river);
  const std::vector<Point3>& stations = river->water.stations;
  EXPECT_LT(stations.front().x(), stations.back().x());
  EXPECT_NEAR(stations.front().z() - stations.back().z(), 1.6, 0.15);
  for (const Point3& s : stations) EXPECT_NEAR(s.z(), Falling(s.x(), 0), 0.04);
  EXPECT_LT(river->evidence.sigma(), 0.05);
}

TEST(FindFallTest, LevelWaterDoesNotFall) {
  EXPECT_FALSE(RiverOf(BoxRim({0, -12}, {400, 12}, [](double, double) { return 10; })));
  EXPECT_FALSE(RiverOf(BoxRim({0, -12}, {400, 12}, [](double x, double y) { return y > 11 || x < 200 ? 12 : 10; })));
}

TEST(FindFallTest, QuaysOnOneSideAreNoObstacle) {
  const auto quays = [](double x, double y) {
    const bool left = x<120, right = x> 200 && x < 320;
    return Falling(x, y) + ((left && y > 0) || (right && y < 0) ? 2.5 : 0);
  };
  EXPECT_TRUE(RiverOf(BoxRim({0, -12}, {400, 12}, quays)));
}

TEST(FindFallTest, AHillyRimIsNone) {
  EXPECT_FALSE(RiverOf(BoxRim({0, -12}, {400, 12}, [](double x, double) { return 10 + 2 * std::sin(x / 40); })));
}

TEST(RiverAxisTest, RunsThroughAllReaches) {
  const std::vector<std::vector<PlaneSegment>> reaches = {BoxRim({252, -15}, {500, 15}, Falling).outline,
                                                          BoxRim({0, -15}, {240, 15}, Falling).outline,
                                                          BoxRim({512, -15}, {700, 15}, Falling).outline};
  const std::vector<Point2> axis = RiverAxis(reaches, kWidth);
  ASSERT_GT(axis.size(), 20u);
  const bool rises = axis.front().x() < axis.back().x();
  for (size_t i = 1; i < axis.size(); ++i) EXPECT_EQ(axis[i].x() > axis[i - 1].x(), rises) << i;
  EXPECT_GT(std::abs(axis.back().x() - axis.front().x()), 650);
}

TEST(RiverAxisTest, PondsAndDitchesHaveNone) {
  EXPECT_TRUE(RiverAxis(std::vector<std::vector<PlaneSegment>>{BoxRim({0, 0}, {40, 60}, Falling).outline}, 60).empty());
  EXPECT_TRUE(
      RiverAxis(std::vector<std::vector<PlaneSegment>>{BoxRim({0, 0}, {400, 3}, Falling).outline}, kWidth).empty());
}

}  // namespace
}  // namespace tilemend
