#include "coordinator/plan/water/river.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace tilemend {
namespace {

constexpr double kTolerance = 0.1;
constexpr double kNoise = 0.05;
constexpr double kWidth = 6;

using Level = std::function<double(double x, double y)>;

double Falling(double x, double) { return 10 - 0.001 * x; }

// The reach of a river along y = 0 from x0 to x1, `half` metres to either side, whose shores have heights of `level`
// with noise, and banks 0.4 m above it one edge landward.
Reach ReachBetween(double x0, double x1, double half, const Level& level, double bank = 0.4) {
  std::mt19937 random(7);
  const auto noise = [&] { return kNoise * std::sqrt(3) * (static_cast<double>(random()) * 0x1p-31 - 1); };
  Reach reach;
  std::vector<Point2> ring;
  for (double x = x0; x <= x1; ++x) ring.emplace_back(x, -half);
  for (double x = x1; x >= x0; --x) ring.emplace_back(x, half);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2& p = ring[i];
    reach.boundary.emplace_back(p, ring[(i + 1) % ring.size()]);
    reach.shore.emplace_back(p.x(), p.y(), level(p.x(), p.y()) + noise());
    reach.bank.push_back(level(p.x(), p.y()) + bank + noise());
  }
  reach.noise = kNoise;
  return reach;
}

TEST(FindRiversTest, ALongFallingReachIsARiver) {
  const std::vector<River> rivers =
      FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, Falling)}, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_TRUE(rivers[0].falls);
  EXPECT_NEAR(rivers[0].width, 30, 2);
  EXPECT_NEAR(rivers[0].profile.fall, 0.5, 0.1);
  EXPECT_LT(rivers[0].profile.water.stations.front().x(), rivers[0].profile.water.stations.back().x());
}

TEST(FindRiversTest, GoesOnUnderABridge) {
  const std::vector<Reach> reaches = {ReachBetween(0, 240, 15, Falling), ReachBetween(252, 500, 15, Falling)};
  const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_EQ(rivers[0].reaches, (std::vector<size_t>{0, 1}));
}

// A centreline ends in a corner of its reach. Along a line that does, places on both sides of a bend have other levels.
TEST(FindRiversTest, ItsLineDoesNotBendUnderABridge) {
  const std::vector<Reach> reaches = {ReachBetween(0, 240, 25, Falling), ReachBetween(252, 500, 25, Falling)};
  const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  const std::vector<Point3>& stations = rivers[0].profile.water.stations;
  for (size_t k = 1; k < stations.size(); ++k) {
    if (stations[k].x() < 150 || stations[k].x() > 350) continue;
    EXPECT_LT(std::abs(stations[k].y()), 5) << "station " << k;
    EXPECT_GT(stations[k].x(), stations[k - 1].x() + 20) << "station " << k;
  }
}

// Both sides of the bridge are one hole where something beside it hangs together.
TEST(FindRiversTest, AReachMayBeInParts) {
  Reach whole = ReachBetween(0, 300, 15, Falling);
  const Reach beyond = ReachBetween(310, 500, 15, Falling);
  whole.boundary.insert(whole.boundary.end(), beyond.boundary.begin(), beyond.boundary.end());
  whole.shore.insert(whole.shore.end(), beyond.shore.begin(), beyond.shore.end());
  whole.bank.insert(whole.bank.end(), beyond.bank.begin(), beyond.bank.end());
  const std::vector<River> rivers = FindRivers(std::vector<Reach>{whole}, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_EQ(rivers[0].reaches, std::vector<size_t>{0});
  EXPECT_GT(rivers[0].profile.stations.back().along, 450);
}

// The ends of the water at the bridge are aslant: the centrelines end in corners on opposite shores. Of wide water
// these are farther apart than any bridge is wide.
TEST(FindRiversTest, GoesOnUnderABridgeThatCrossesAslant) {
  for (const double half_width : {12, 25}) {
    std::vector<Reach> reaches = {ReachBetween(0, 240, half_width, Falling),
                                  ReachBetween(252, 500, half_width, Falling)};
    const auto slant = [](auto& p) { p.x() += 0.8 * p.y(); };
    for (Reach& reach : reaches) {
      for (auto& [a, b] : reach.boundary) slant(a), slant(b);
      for (Point3& p : reach.shore) slant(p);
    }
    const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
    ASSERT_EQ(rivers.size(), 1u) << half_width;
    EXPECT_EQ(rivers[0].reaches.size(), 2u);
  }
}

void Turn(double angle, const Point2& centre, Reach& reach) {
  const Eigen::Rotation2Dd turn(angle);
  for (auto& [a, b] : reach.boundary) a = centre + turn * (a - centre), b = centre + turn * (b - centre);
  for (Point3& p : reach.shore) p.head<2>() = centre + turn * (p.head<2>() - centre);
}

// The second reach is turned about a place under the bridge: its near end is off the line of the first, or close to it
// in another direction.
TEST(FindRiversTest, GoesOnWhereItBendsUnderABridge) {
  struct Bend {
    double half_width, bridge, angle;
  };
  for (const Bend& bend : {Bend{5, 26, 1}, Bend{12, 6, 1.7}}) {
    std::vector<Reach> reaches = {ReachBetween(0, 240, bend.half_width, Falling),
                                  ReachBetween(240 + bend.bridge, 500, bend.half_width, Falling)};
    Turn(bend.angle, Point2(240, 0), reaches[1]);
    const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
    ASSERT_EQ(rivers.size(), 1u) << bend.angle;
    EXPECT_EQ(rivers[0].reaches.size(), 2u);
  }
}

// A weir: the levels of the second are 4 m above those of the first, which makes no river of both.
TEST(FindRiversTest, WhatIsNoneTogetherMayBeOneAlone) {
  const auto above = [](double x, double y) { return Falling(x, y) + 4; };
  const std::vector<Reach> reaches = {ReachBetween(0, 240, 12, Falling), ReachBetween(252, 500, 12, above)};
  const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 2u);
  EXPECT_EQ(rivers[0].reaches.size(), 1u);
}

// Quays of two heights for 70 m, then one on the left shore for as long as the other half of the river has none.
TEST(FindRiversTest, StretchesBetweenQuaysSayNothingOfItsSides) {
  const auto level = [](double x, double y) {
    const double quay = x < 70 ? (y > 0 ? 1.8 : 0.9) : (x < 235 && y > 0 ? 0.8 : 0);
    return Falling(x, y) + quay;
  };
  EXPECT_EQ(FindRivers(std::vector<Reach>{ReachBetween(0, 400, 12, level)}, kTolerance, kWidth).size(), 1u);
}

// A quay along one shore for six stations of ten, now the left and now the right one.
TEST(FindRiversTest, AQuayMayRunAlongMostOfTheRiver) {
  const auto level = [](double x, double y) {
    const bool left = x<120, right = x> 200 && x < 320;
    return Falling(x, y) + ((left && y > 0) || (right && y < 0) ? 2.5 : 0);
  };
  EXPECT_EQ(FindRivers(std::vector<Reach>{ReachBetween(0, 400, 12, level)}, kTolerance, kWidth).size(), 1u);
}

TEST(FindRiversTest, GroundThatIsHigherOnOneSideIsNoQuay) {
  const auto level = [](double x, double y) {
    const bool left = x<120, right = x> 200 && x < 320;
    return Falling(x, y) + ((left && y > 0) || (right && y < 0) ? 0.35 : 0);
  };
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 400, 12, level)}, kTolerance, kWidth).empty());
}

TEST(FindRiversTest, WhatIsFarApartIsNotOne) {
  const std::vector<Reach> reaches = {ReachBetween(0, 240, 15, Falling), ReachBetween(300, 600, 15, Falling)};
  EXPECT_EQ(FindRivers(reaches, kTolerance, kWidth).size(), 2u);
}

TEST(FindRiversTest, ALongLakeDoesNotFall) {
  const std::vector<River> rivers =
      FindRivers(std::vector<Reach>{ReachBetween(0, 300, 15, [](double, double) { return 10; })}, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_FALSE(rivers[0].falls);
}

TEST(FindRiversTest, NoRiverIsSteepShortNarrowOrAslant) {
  const auto steep = [](double x, double) { return 10 - 0.03 * x; };
  const auto aslant = [](double x, double y) { return 10 - 0.001 * x + 0.05 * y; };
  const auto hilly = [](double x, double) { return 10 + 2 * std::sin(x / 40); };
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, steep)}, kTolerance, kWidth).empty());
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, aslant)}, kTolerance, kWidth).empty());
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, hilly)}, kTolerance, kWidth).empty());
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 60, 15, Falling)}, kTolerance, kWidth).empty());
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 2, Falling)}, kTolerance, kWidth).empty());
}

TEST(FindRiversTest, ASteepOneFallsFarAndEvenly) {
  const auto steep = [](double x, double) { return 10 - 0.012 * x; };
  const auto uneven = [](double x, double) { return 10 - 0.012 * x - 2 * std::max(0.0, std::sin(x / 50)); };
  const std::vector<River> rivers = FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, steep)}, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_NEAR(rivers[0].profile.fall, 6, 0.5);
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 150, 15, steep)}, kTolerance, kWidth).empty());
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, uneven)}, kTolerance, kWidth).empty());
}

TEST(FindRiversTest, NoRiverHasGroundBelowItBesideIt) {
  EXPECT_TRUE(FindRivers(std::vector<Reach>{ReachBetween(0, 500, 15, Falling, -0.4)}, kTolerance, kWidth).empty());
}

TEST(FindRiversTest, AForcedReachHasToBeLongAndToFall) {
  Reach low_banks = ReachBetween(0, 500, 15, Falling, -0.4);
  low_banks.forced = true;
  EXPECT_EQ(FindRivers(std::vector<Reach>{low_banks}, kTolerance, kWidth).size(), 1u);
  Reach level = ReachBetween(0, 500, 15, [](double, double) { return 10; });
  level.forced = true;
  EXPECT_TRUE(FindRivers(std::vector<Reach>{level}, kTolerance, kWidth).empty());
}

TEST(FindRiversTest, AGivenCentrelineMakesARiverOfAnyShape) {
  Reach pond = ReachBetween(0, 60, 30, Falling, -0.4);
  pond.forced = true;
  pond.centreline = {{60, 0}, {0, 0}};
  const std::vector<River> rivers = FindRivers(std::vector<Reach>{pond}, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_LT(rivers[0].profile.water.stations.front().x(), rivers[0].profile.water.stations.back().x());
}

TEST(FindRiversTest, ReachesAlongOneGivenCentrelineAreOneRiver) {
  std::vector<Reach> reaches = {ReachBetween(0, 240, 15, Falling), ReachBetween(300, 600, 15, Falling)};
  for (Reach& reach : reaches) reach.centreline = {{0, 0}, {600, 0}};
  const std::vector<River> rivers = FindRivers(reaches, kTolerance, kWidth);
  ASSERT_EQ(rivers.size(), 1u);
  EXPECT_TRUE(rivers[0].given);
  EXPECT_EQ(rivers[0].reaches, (std::vector<size_t>{0, 1}));
  EXPECT_NEAR(rivers[0].profile.fall, 0.6, 0.1);
}

TEST(FindRiversTest, NarrowerOnesCanBeLeftOut) {
  const std::vector<Reach> reaches = {ReachBetween(0, 500, 10, Falling)};
  EXPECT_EQ(FindRivers(reaches, kTolerance, 15).size(), 1u);
  EXPECT_TRUE(FindRivers(reaches, kTolerance, 30).empty());
}

}  // namespace
}  // namespace tilemend
