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

TEST(EdgeHeightsTest, BeginAtTheRim) {
  const auto step = [](double x, double y) { return Slope(x, y) + (x > 7.5 ? 0.4 : 0); };
  HalfPlate half(step);
  ASSERT_TRUE(SolveEdge(kWidth, half.edge, half.plate.problem));
  const Point3& last = half.plate.problem.points[half.plate.at[{7, 0}]];
  EXPECT_NEAR(last.z(), step(8, 0), 0.3);
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

TEST(EdgeHeightsTest, StayWithinReach) {
  const auto cliff = [](double, double y) { return y < -9.5 ? -12.0 : 0.8 * y; };
  HalfPlate half(cliff);
  const HeightReach reach = ReachOfRim(half.plate.problem);
  ASSERT_TRUE(SolveEdge(kWidth, half.edge, half.plate.problem));
  for (const int32_t v : half.edge) EXPECT_TRUE(reach.Holds(half.plate.problem.points[v].z()));
}

TEST(EdgeHeightsTest, OfAWidthThatIsNotKnownAreAMembranes) {
  HalfPlate half(Slope), membrane = half;
  ASSERT_TRUE(SolveEdge(0, half.edge, half.plate.problem));
  ASSERT_TRUE(SolveMembrane(membrane.plate.problem));
  EXPECT_EQ(half.EdgeError(Slope), membrane.EdgeError(Slope));
}

}  // namespace
}  // namespace tilemend
