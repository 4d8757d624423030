#include "worker/fill/surface/edge_heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tests/worker/fill/surface/plates.h"
#include "worker/fill/surface/height_reach.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

using testing::kHalf, testing::MakePlate, testing::Nowhere, testing::Plate;

constexpr double kWidth = 2 * kHalf;

double Slope(double x, double y) { return 0.5 * y + 0.3 * std::sin(0.2 * x); }

// The half of a hole that lies south of the edge of the area, y = 0.
struct HalfPlate {
  explicit HalfPlate(const HeightFunction& height)
      : plate(MakePlate(
            height, [](double, double y) { return y <= 0; }, Nowhere)) {
    for (const auto& [place, v] : plate.at) {
      if (place.second == 0 && !plate.problem.known[v]) edge.push_back(static_cast<int32_t>(v));
    }
    for (const auto& [place, v] : plate.at) {
      if (place.second == 0) plate.problem.has_equation[v] = false;
    }
  }

  double EdgeError(const HeightFunction& height) const {
    double largest = 0;
    for (const int32_t v : edge) {
      const Point3& p = plate.problem.points[v];
      largest = std::max(largest, std::abs(p.z() - height(p.x(), p.y())));
    }
    return largest;
  }

  Plate plate;
  std::vector<int32_t> edge;
};

TEST(EdgeHeightsTest, GoOnWithTheSlopeOfTheRim) {
  HalfPlate half(Slope), membrane = half;
  ASSERT_TRUE(SolveEdge(kWidth, half.edge, half.plate.problem));
  ASSERT_TRUE(SolveMembrane(membrane.plate.problem));
  EXPECT_LT(half.EdgeError(Slope), 0.5 * membrane.EdgeError(Slope));
}

// Where a wall ends the rim, 2 m up: nothing is foretold from it, but the edge begins there.
TEST(EdgeHeightsTest, BeginAtTheRim) {
  const auto on_wall = [](double x, double y) { return x >= kHalf && y > -4; };
  const auto with_wall = [&](double x, double y) { return Slope(x, y) + (on_wall(x, y) ? 2 : 0); };
  HalfPlate half(with_wall);
  for (const auto& [place, v] : half.plate.at) {
    if (on_wall(place.first, place.second)) half.plate.problem.has_equation[v] = false;
  }
  half.plate.problem.band.clear();
  ASSERT_TRUE(SolveEdge(kWidth, half.edge, half.plate.problem));
  const auto above_slope = [&](double x) { return half.plate.problem.points[half.plate.at[{x, 0}]].z() - Slope(x, 0); };
  EXPECT_GT(above_slope(kHalf - 1), 1.2);
  EXPECT_LT(above_slope(-kHalf + 1), 0.5);
}

TEST(EdgeHeightsTest, AreAMembranesUnderItsTension) {
  HalfPlate half(Slope), membrane = half;
  half.plate.problem.tension = 1e5 / (kWidth * kWidth);
  ASSERT_TRUE(SolveEdge(kWidth, half.edge, half.plate.problem));
  ASSERT_TRUE(SolveMembrane(membrane.plate.problem));
  for (const int32_t v : half.edge) {
    EXPECT_EQ(half.plate.problem.points[v], membrane.plate.problem.points[v]);
  }
}

// Steep ground in the south alone: as it goes on, the edge would be too high.
TEST(EdgeHeightsTest, StayWithinReach) {
  const auto steep = [](double, double y) { return 2 * y; };
  Plate plate = MakePlate(
      steep, [](double x, double y) { return y <= 0 && std::abs(x) <= 5; }, Nowhere);
  std::vector<int32_t> edge;
  for (const auto& [place, v] : plate.at) {
    const bool at_edge = place.second == 0 || std::abs(place.first) == 5;
    if (at_edge) plate.problem.has_equation[v] = false;
    if (at_edge && !plate.problem.known[v]) edge.push_back(static_cast<int32_t>(v));
  }
  const HeightReach reach = ReachOfRim(plate.problem);
  ASSERT_TRUE(SolveEdge(40, edge, plate.problem));
  double highest = reach.lo;
  for (const int32_t v : edge) {
    EXPECT_TRUE(reach.Holds(plate.problem.points[v].z()));
    highest = std::max(highest, plate.problem.points[v].z());
  }
  EXPECT_GT(highest, 2 * -kHalf + 1) << "a membrane, that is level";
}

TEST(EdgeHeightsTest, OfAWidthThatIsNotKnownAreAMembranes) {
  HalfPlate half(Slope), membrane = half;
  ASSERT_TRUE(SolveEdge(0, half.edge, half.plate.problem));
  ASSERT_TRUE(SolveMembrane(membrane.plate.problem));
  EXPECT_EQ(half.EdgeError(Slope), membrane.EdgeError(Slope));
}

}  // namespace
}  // namespace tilemend
