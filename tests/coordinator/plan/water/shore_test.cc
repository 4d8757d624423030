#include "coordinator/plan/water/shore.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/surveyed_scene.h"
#include "tests/support/water_scenes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

// One hole of these segments.
std::vector<int32_t> ShoreOfSegments(const std::vector<RimSegment>& segments) {
  Plan plan;
  plan.holes.emplace_back();
  plan.holes[0].segments = segments;
  return ShoreOf(plan, {0});
}

TEST(ShoreTest, GoesAroundLoopsFromTheirLowestVertex) {
  EXPECT_THAT(ShoreOfSegments({{2, 0}, {0, 5}, {5, 2}, {9, 7}, {7, 9}}), ElementsAre(0, 5, 2, 7, 9));
}

TEST(ShoreTest, GoesAlongChainsBetweenSeamsFirst) {
  EXPECT_THAT(ShoreOfSegments({{0, 1}, {1, 0}, {5, 3}, {3, 4}, {4, 8, true}, {8, 5, true}}),
              ElementsAre(5, 3, 4, 0, 1));
}

TEST(ShoreTest, DoesNotDependOnTheOrderOfSegments) {
  std::vector<RimSegment> segments = {{2, 0}, {0, 5}, {5, 2}, {4, 3}, {3, 6}, {7, 2}, {2, 8}, {8, 7}};
  const std::vector<int32_t> shore = ShoreOfSegments(segments);
  for (int turn = 0; turn < 8; ++turn) {
    std::rotate(segments.begin(), segments.begin() + 1, segments.end());
    EXPECT_EQ(ShoreOfSegments(segments), shore);
  }
}

TEST(ShoreTest, GoesAlongTheRim) {
  const SurveyedScene scene = PictureScene({"####|####", "#..#|#..#", "#...|...#", "####|####", "----+----",  //
                                            "####|####", "####|####", "####|####", "####|####"},
                                           4);
  const Plan plan = MakePlan(scene.Input(), {});
  std::vector<int32_t> holes;
  for (size_t h = 0; h < plan.holes.size(); ++h) holes.push_back(static_cast<int32_t>(h));
  const std::vector<int32_t> shore = ShoreOf(plan, holes);
  EXPECT_THAT(shore, SizeIs(18));  // two squares of 2 m by 2 m and a passage of 1 m by 2 m between them
  EXPECT_THAT(std::set<int32_t>(shore.begin(), shore.end()), SizeIs(18));
  for (size_t i = 0; i < shore.size(); ++i) {
    const Point3 step = plan.vertices[shore[(i + 1) % shore.size()]].position - plan.vertices[shore[i]].position;
    EXPECT_NEAR(step.norm(), 1, 1e-12);
  }
}

TEST(ShoreTest, TellsNoiseFromSlopes) {
  for (const double noise : {0.0, 0.05, 0.2}) {
    SceneMakerOptions options = LakeOverNineCells(Cut::kClipped);
    options.noise = noise;
    options.terrain = [](double x, double y) { return 0.05 * x - 0.02 * y; };
    const SurveyedScene scene = SurveyScene(MakeScene(options));
    const PlanInput input = scene.Input();
    const Plan plan = MakePlan(input, {});
    std::vector<int32_t> holes;
    for (size_t h = 0; h < plan.holes.size(); ++h) holes.push_back(static_cast<int32_t>(h));
    const std::vector<std::vector<int32_t>> shores = {ShoreOf(plan, holes)};
    const ShoreGround ground = FindGround(plan, input, shores).at(0);
    EXPECT_NEAR(ground.noise, noise / std::sqrt(12), 0.2 * noise / std::sqrt(12) + 1e-5);
    EXPECT_EQ(ground.bank.size(), shores[0].size());
  }
}

TEST(ShoreTest, TakesTheBankFromOneEdgeLandward) {
  // A pond of 2 x 2 squares at height 5 in ground that is 1 m higher one edge away.
  const auto ground = [](double x, double y) { return std::max(std::abs(x - 4), std::abs(y - 4)) < 1.5 ? 5 : 6; };
  std::vector<std::string> picture(8, std::string(8, '#'));
  for (const int row : {3, 4}) picture[row].replace(3, 2, "..");
  const SurveyedScene scene = PictureScene(picture, 8, ground);
  const PlanInput input = scene.Input();
  const Plan plan = MakePlan(input, {});
  const std::vector<std::vector<int32_t>> shores = {ShoreOf(plan, {0})};
  ASSERT_THAT(shores[0], SizeIs(8));
  const ShoreGround ground_there = FindGround(plan, input, shores).at(0);
  for (const double bank : ground_there.bank) EXPECT_DOUBLE_EQ(bank, 6);
}

}  // namespace
}  // namespace tilemend
