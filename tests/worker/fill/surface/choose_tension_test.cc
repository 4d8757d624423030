#include "worker/fill/surface/choose_tension.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

// A square hole of side 2 half in a mesh of unit squares, with one ring of triangles around it.
ThinPlateProblem SquareHole(int32_t half, const HeightFunction& height) {
  const TriMesh mesh = SquaresMesh(-half - 1, half + 1, -half - 1, half + 1, [](int32_t, int32_t) { return true; });
  ThinPlateProblem problem;
  const auto reach = [](const Point3& p) { return p.head<2>().cwiseAbs().maxCoeff(); };
  for (const Point3& p : mesh.points) {
    problem.known.push_back(reach(p) >= half);
    problem.has_equation.push_back(reach(p) <= half);
    problem.points.emplace_back(p.x(), p.y(), reach(p) >= half ? height(p.x(), p.y()) : 0);
  }
  for (const Triangle& t : mesh.triangles) {
    const bool band = std::all_of(t.begin(), t.end(), [&](int32_t v) { return reach(mesh.points[v]) >= half; });
    (band ? problem.band : problem.patch).push_back(t);
  }
  return problem;
}

double Hill(double x, double y) { return 2 * std::sin(x / 30 + 0.3) * std::cos(y / 40); }

// Waves much shorter than the hole is wide: where a slope says nothing of what is far from it.
double Rough(double x, double y) {
  return std::sin(1.3 * x + 0.4 * y) + std::cos(0.9 * y - 1.1 * x + 1) + 0.7 * std::sin(2.1 * y + 0.3 * x + 2);
}

// The problem with its points in reverse order.
ThinPlateProblem Reversed(const ThinPlateProblem& problem) {
  ThinPlateProblem reversed = problem;
  const auto last = static_cast<int32_t>(problem.points.size()) - 1;
  std::reverse(reversed.points.begin(), reversed.points.end());
  std::reverse(reversed.known.begin(), reversed.known.end());
  std::reverse(reversed.has_equation.begin(), reversed.has_equation.end());
  for (auto* triangles : {&reversed.patch, &reversed.band}) {
    for (Triangle& t : *triangles) {
      for (int32_t& v : t) v = last - v;
    }
    std::reverse(triangles->begin(), triangles->end());
  }
  return reversed;
}

TEST(ChooseTensionTest, ASmoothHillWantsNone) {
  const HoldOut choice = ChooseTension(SquareHole(16, Hill), 32);
  EXPECT_EQ(choice.tension, 0);
  EXPECT_GT(choice.blocks, 8);
  EXPECT_LT(choice.error, choice.error_at_start);
  EXPECT_LT(choice.error, 0.2);
}

TEST(ChooseTensionTest, RoughGroundWantsAMembrane) {
  const HoldOut choice = ChooseTension(SquareHole(16, Rough), 32);
  EXPECT_GE(choice.tension, 300.0 / (32 * 32));
  EXPECT_LE(choice.error, choice.error_at_start);
}

// Noise in single heights makes slopes at the rim say less of the ground, however it goes on.
TEST(ChooseTensionTest, NoiseOnAHillWantsTension) {
  const auto with_noise = [](double share) {
    return [share](double x, double y) { return Hill(x, y) + share * Rough(29 * x, 31 * y); };
  };
  const double width = 32;
  double before = 0;
  for (const double share : {0.003, 0.03, 0.3}) {
    const HoldOut choice = ChooseTension(SquareHole(16, with_noise(share)), width);
    EXPECT_GE(choice.tension, before) << share;
    before = choice.tension;
  }
  EXPECT_GE(before, 100 / (width * width));
}

// A few heights of something that stands at the rim do not change the choice.
TEST(ChooseTensionTest, OutliersDoNotDecide) {
  const auto with_car = [](double x, double y) { return Hill(x, y) + (x < -15 && std::abs(y - 4) < 2 ? 1.5 : 0.0); };
  EXPECT_LE(ChooseTension(SquareHole(16, with_car), 32).tension, 10.0 / (32 * 32));
}

// No slope at such a rim goes on anywhere.
TEST(ChooseTensionTest, NoiseOnAPlaneWantsAMembraneWhateverItsSize) {
  const auto noise = [](double x, double y) {
    return 0.01 * std::sin(12.9898 * x + 78.233 * y + std::sin(37 * x * y)) + 0.1 * x - 0.3 * y;
  };
  for (const int32_t half : {4, 7, 16}) {
    const HoldOut choice = ChooseTension(SquareHole(half, noise), 2 * half);
    EXPECT_GT(choice.tension, 1000.0 / (4 * half * half)) << half;
    EXPECT_GT(choice.blocks, 0) << half;
  }
}

TEST(ChooseTensionTest, APlaneIsNoNoise) {
  const auto plane = [](double x, double y) { return 0.1 * x - 0.3 * y; };
  EXPECT_EQ(ChooseTension(SquareHole(7, plane), 14).tension, 0);
}

TEST(ChooseTensionTest, TakesPointsThatAllButCoincide) {
  for (const double gap : {1e-3, 1e-6, 1e-9}) {
    for (const double width : {32.0, 1.0}) {
      ThinPlateProblem problem = SquareHole(16, Rough);
      for (Point3& p : problem.points) {
        const double reach = p.head<2>().cwiseAbs().maxCoeff();
        if (reach > 16) p.head<2>() *= (16 + gap) / reach;
      }
      const HoldOut choice = ChooseTension(problem, width);
      EXPECT_TRUE(std::isfinite(choice.error)) << gap << " " << width;
      EXPECT_GT(choice.error, 0) << gap << " " << width;
    }
  }
}

TEST(ChooseTensionTest, TheScaleOfLengthsAndHeightsIsOfNoImportance) {
  ThinPlateProblem problem = SquareHole(16, Rough);
  const HoldOut choice = ChooseTension(problem, 32);
  for (Point3& p : problem.points) p *= 4;
  const HoldOut larger = ChooseTension(problem, 128);
  EXPECT_NEAR(larger.tension * 16, choice.tension, 1e-12 * choice.tension);
  EXPECT_NEAR(larger.error, 4 * choice.error, 1e-6 * choice.error);
}

TEST(ChooseTensionTest, DoesNotDependOnTheOrderOfPoints) {
  const ThinPlateProblem problem = SquareHole(20, Rough);
  const HoldOut choice = ChooseTension(problem, 40), again = ChooseTension(Reversed(problem), 40);
  EXPECT_EQ(choice.tension, again.tension);
  EXPECT_EQ(choice.error, again.error);
  EXPECT_EQ(choice.blocks, again.blocks);
}

TEST(ChooseTensionTest, ASmallRimIsNotTested) {
  const HoldOut choice = ChooseTension(SquareHole(2, Rough), 4);  // 16 rim points
  EXPECT_EQ(choice.blocks, 0);
  EXPECT_EQ(choice.tension, 0);
}

// As where all but a corner of the rim stands on houses and trees.
TEST(ChooseTensionTest, ARimThatTellsHardlyAnySlopeWantsTension) {
  const ThinPlateProblem whole = SquareHole(8, Rough);
  ThinPlateProblem problem = whole;
  for (size_t v = 0; v < problem.points.size(); ++v) {
    const Point3& p = problem.points[v];
    if (problem.known[v] && p.x() + p.y() < 12) problem.has_equation[v] = false;
  }
  const HoldOut choice = ChooseTension(problem, 16);
  EXPECT_EQ(choice.blocks, 0);
  EXPECT_EQ(choice.tension, 300.0 / (16 * 16));
  EXPECT_GT(ChooseTension(whole, 16).blocks, 0);
}

TEST(ChooseTensionTest, HeightsFarFromZeroChangeNothing) {
  const HoldOut choice = ChooseTension(SquareHole(16, Rough), 32);
  const HoldOut high = ChooseTension(SquareHole(16, [](double x, double y) { return Rough(x, y) + 4096; }), 32);
  EXPECT_EQ(high.tension, choice.tension);
  EXPECT_NEAR(high.error, choice.error, 1e-6);
}

}  // namespace
}  // namespace tilemend
