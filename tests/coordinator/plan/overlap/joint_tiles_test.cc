#include "coordinator/plan/overlap/joint_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;

using Picture = std::vector<std::string>;

Plan PlanOf(const SurveyedScene& scene) { return MakePlan(scene.Input(), {}); }

// What the plan says, apart from how the seams were laid.
std::string Summary(const Plan& plan) {
  return CountsOf(plan) + "; clusters " + std::to_string(plan.clusters) + ", layers " + std::to_string(plan.layers);
}

class JointTilesTest : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Margins, JointTilesTest, ::testing::Values(0.05, 0.1, 0.25));

TEST_P(JointTilesTest, CountsHolesAsOnTheClippedScene) {
  EXPECT_EQ(Summary(PlanOf(OverlappingScene(kWaters, 10, GetParam()))), Summary(PlanOf(PictureScene(kWaters, 10))));
}

TEST_P(JointTilesTest, CountsAHoleOverSeveralPiecesOnce) {
  const Plan plan = PlanOf(OverlappingScene(kWaters, 10, GetParam(), 2));
  EXPECT_EQ(Summary(plan), Summary(PlanOf(PictureScene(kWaters, 10))));
  EXPECT_THAT(plan.left, IsEmpty());
}

// Along a border where only one tile has surface, that tile's own vertices bound the hole.
TEST(JointTilesBorderTest, ACellWithoutATileIsOneHole) {
  const Picture picture = {"####|....|####", "####|....|####", "####|....|####", "####|....|####"};
  const Plan plan = PlanOf(OverlappingScene(picture, 4, 0.1));
  EXPECT_EQ(Summary(plan), Summary(PlanOf(PictureScene(picture, 4))));
}

// A gap all along a border is how the tiles are stored.
TEST(JointTilesBorderTest, AGapBetweenTilesIsNoHole) {
  const Picture picture = {"####|####", "####|####", "####|####", "####|####"};
  EXPECT_THAT(PlanOf(OverlappingScene(picture, 4, -0.05)).holes, IsEmpty());
}

}  // namespace
}  // namespace tilemend
