#include "worker/fill/surface/free_rim.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using testing::Everywhere;
using testing::Hills;
using testing::kHalf;
using testing::MakePlate;
using testing::Nowhere;
using testing::Plate;

double Slope(double x, double y) { return 5 + 0.1 * x - 0.06 * y; }

bool UnderHouse(const Point3& p) { return p.x() >= kHalf && p.y() > -4 && p.y() < 5; }

// A house of `height` metres over the rim and the band on one side.
std::vector<bool> Build(double height, ThinPlateProblem& problem) {
  std::vector<bool> on_object(problem.points.size(), false);
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (!problem.known[v] || !UnderHouse(problem.points[v])) continue;
    on_object[v] = true;
    problem.points[v].z() += height;
  }
  return on_object;
}

double LargestError(const ThinPlateProblem& problem, double (*height)(double, double)) {
  double largest = 0;
  for (size_t v = 0; v < problem.points.size(); ++v) {
    const Point3& p = problem.points[v];
    if (!problem.known[v]) largest = std::max(largest, std::abs(p.z() - height(p.x(), p.y())));
  }
  return largest;
}

TEST(FreeRimTest, UnderAHouseAPlaneGoesOn) {
  Plate plate = MakePlate(Slope, Everywhere, Nowhere);
  const std::vector<bool> on_object = Build(10, plate.problem);
  ASSERT_TRUE(FreeRim(on_object, {}, plate.problem));
  ASSERT_TRUE(SolveThinPlate(plate.problem).has_value());
  EXPECT_LT(LargestError(plate.problem, Slope), 1e-6);
}

// The triangle at the object is so obtuse that the solved membrane goes far below all that is known.
TEST(FreeRimTest, BesideNeedlesTheGroundIsNoDeeperThanWhatIsKnown) {
  ThinPlateProblem problem;
  problem.points = {{2, 0, 40}, {0, 0, 10}, {1, 0.05, 0}, {1, -1, 0}, {3, -1, 0}, {3, 1, 0}};
  problem.patch = {{1, 0, 2}, {1, 3, 0}, {3, 4, 0}, {0, 4, 5}, {0, 5, 2}};
  problem.known.assign(problem.points.size(), true);
  problem.has_equation.assign(problem.points.size(), false);
  const std::vector<bool> on_object = {true, false, false, false, false, false};
  ASSERT_TRUE(FreeRim(on_object, {}, problem));
  EXPECT_GT(problem.points[0].z(), -4);
  EXPECT_LT(problem.points[0].z(), 10);
}

TEST(FreeRimTest, TheHeightOfTheHouseDoesNotMatter) {
  Plate low = MakePlate(Hills, Everywhere, Nowhere), high = low;
  ASSERT_TRUE(FreeRim(Build(3, low.problem), {}, low.problem));
  ASSERT_TRUE(FreeRim(Build(30, high.problem), {}, high.problem));
  ASSERT_TRUE(SolveThinPlate(low.problem).has_value());
  ASSERT_TRUE(SolveThinPlate(high.problem).has_value());
  for (size_t v = 0; v < low.problem.points.size(); ++v) {
    if (low.problem.known[v]) continue;
    EXPECT_NEAR(low.problem.points[v].z(), high.problem.points[v].z(), 1e-9);
  }
}

TEST(FreeRimTest, TakesTheGroundThatIsKnown) {
  Plate plate = MakePlate(Slope, Everywhere, Nowhere), without = plate;
  const std::vector<bool> on_object = Build(10, plate.problem);
  Build(10, without.problem);
  std::vector<std::optional<double>> ground(on_object.size());
  size_t first = 0;
  while (!on_object[first]) ++first;
  ground[first] = 4.25;
  ASSERT_TRUE(FreeRim(on_object, ground, plate.problem));
  EXPECT_EQ(plate.problem.points[first].z(), 4.25);
  ASSERT_TRUE(FreeRim(on_object, {}, without.problem));
  EXPECT_EQ(plate.problem.band, without.problem.band);
  EXPECT_EQ(plate.problem.has_equation, without.problem.has_equation);
}

TEST(FreeRimTest, WithoutObjectsNothingChanges) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const ThinPlateProblem before = plate.problem;
  ASSERT_TRUE(FreeRim(std::vector<bool>(plate.problem.points.size(), false), {}, plate.problem));
  EXPECT_EQ(plate.problem.points, before.points);
  EXPECT_EQ(plate.problem.band, before.band);
  EXPECT_EQ(plate.problem.has_equation, before.has_equation);
}

TEST(FreeRimTest, WithoutGroundNothingChanges) {
  Plate plate = MakePlate(Hills, Everywhere, Nowhere);
  const ThinPlateProblem before = plate.problem;
  ASSERT_TRUE(FreeRim(std::vector<bool>(plate.problem.points.size(), true), {}, plate.problem));
  EXPECT_EQ(plate.problem.points, before.points);
}

}  // namespace
}  // namespace tilemend
