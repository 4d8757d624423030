#include "coordinator/plan/water/shore_objects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace tilemend {
namespace {

using Height = std::function<double(double x, double y)>;

// A round shore of 30 m radius about `centre`, its points 1 m apart in three rows: the rim and two landward.
struct Shore {
  std::vector<Point3> rim, around;
};

Shore RoundShore(const Height& height, const Point2& centre = {0, 0}) {
  Shore shore;
  constexpr int kPoints = 188;
  for (int i = 0; i < kPoints; ++i) {
    for (int row = 0; row < 3; ++row) {
      const double angle = 2 * M_PI * i / kPoints, radius = 30 + row;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      (row == 0 ? shore.rim : shore.around).emplace_back(centre.x() + x, centre.y() + y, height(x, y));
    }
  }
  return shore;
}

bool InHouse(double x, double y) { return x > 25 && std::abs(y) < 5; }

double Meadow(double x, double y) { return 40 + 0.2 * x - 0.1 * y + 0.3 * std::sin(x / 9); }
double MeadowWithHouse(double x, double y) { return Meadow(x, y) + (InHouse(x, y) ? 6 : 0); }

std::vector<bool> StandsOnObject(const Shore& shore, const ObjectRule& rule = {}) {
  std::vector<bool> stands;
  for (const double step : StepsDown(shore.rim, shore.around, rule)) stands.push_back(step > rule.slope);
  return stands;
}

TEST(StepsDownTest, AHouseStandsOnTheShore) {
  const Shore shore = RoundShore(MeadowWithHouse);
  const std::vector<bool> on_object = StandsOnObject(shore);
  for (size_t i = 0; i < shore.rim.size(); ++i) {
    EXPECT_EQ(on_object[i], InHouse(shore.rim[i].x(), shore.rim[i].y())) << shore.rim[i].transpose();
  }
}

TEST(StepsDownTest, GroundHasNone) {
  for (const double slope : {0.0, 0.3, 0.9}) {
    const Shore shore =
        RoundShore([&](double x, double y) { return slope * x + 0.4 * std::sin(x / 5) * std::cos(y / 7); });
    const std::vector<bool> on_object = StandsOnObject(shore);
    EXPECT_EQ(std::count(on_object.begin(), on_object.end(), true), 0) << slope;
  }
}

TEST(StepsDownTest, AWideRoofCountsAsGround) {
  const Shore shore = RoundShore([](double x, double) { return x > 0 ? 6.0 : 0.0; });
  const std::vector<bool> on_object = StandsOnObject(shore, {.radius = 4});
  const auto far_on_roof = std::max_element(shore.rim.begin(), shore.rim.end(),
                                            [](const Point3& a, const Point3& b) { return a.x() < b.x(); });
  EXPECT_FALSE(on_object[far_on_roof - shore.rim.begin()]);
}

TEST(StepsDownTest, TheOrderOfPointsDoesNotMatter) {
  Shore shore = RoundShore(MeadowWithHouse);
  std::vector<bool> on_object = StandsOnObject(shore);
  std::reverse(shore.rim.begin(), shore.rim.end());
  std::reverse(shore.around.begin(), shore.around.end());
  std::reverse(on_object.begin(), on_object.end());
  EXPECT_EQ(StandsOnObject(shore), on_object);
}

TEST(StepsDownTest, NorDoesThePlaceOnTheMap) {
  const Shore here = RoundShore(MeadowWithHouse), there = RoundShore(MeadowWithHouse, {512000, 4096000});
  EXPECT_EQ(StandsOnObject(here), StandsOnObject(there));
}

TEST(AreWallsTest, AHouseHasThem) {
  const Shore shore = RoundShore(MeadowWithHouse);
  EXPECT_TRUE(AreWalls(StepsDown(shore.rim, shore.around)));
}

TEST(AreWallsTest, RoughGroundHasSlopesOfAllKinds) {
  const Shore shore = RoundShore([](double x, double y) { return 6 * std::sin(x / 4) * std::cos(y / 5); });
  const std::vector<double> steps = StepsDown(shore.rim, shore.around);
  EXPECT_GT(*std::max_element(steps.begin(), steps.end()), ObjectRule{}.slope);
  EXPECT_FALSE(AreWalls(steps));
}

// As many steps of each steepness.
std::vector<double> Steps(int level, int gentle, int steep, int walls) {
  std::vector<double> steps(level, 0);
  steps.insert(steps.end(), gentle, 0.4);
  steps.insert(steps.end(), steep, 0.7);
  steps.insert(steps.end(), walls, 2.5);
  return steps;
}

TEST(AreWallsTest, GentleSlopesSpeakForRoughGroundToo) { EXPECT_FALSE(AreWalls(Steps(200, 25, 10, 10))); }

TEST(AreWallsTest, LowThingsBesideThemDoNotHideWalls) { EXPECT_TRUE(AreWalls(Steps(50, 0, 15, 10))); }

TEST(AreWallsTest, MountainsAreSteepAllOver) { EXPECT_FALSE(AreWalls(Steps(30, 10, 15, 35))); }

TEST(AreWallsTest, DenseTownsHaveWallsAlone) { EXPECT_TRUE(AreWalls(Steps(30, 10, 8, 40))); }

TEST(AreWallsTest, WhereNothingIsSteepThereAreNone) { EXPECT_FALSE(AreWalls(std::vector<double>{0, 0.1, 0.2})); }

}  // namespace
}  // namespace tilemend
