#include "coordinator/waves/planned_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/coordinator/waves/made_plan.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(HolesToFillTest, AllThatCanBeFilledWithoutAChoice) {
  EXPECT_THAT(HolesToFill(MadePlan(), {}),
              ElementsAre(Pair(CellId{0, 0}, ElementsAre(0)), Pair(CellId{1, 0}, ElementsAre(1, 2)),
                          Pair(CellId{2, 0}, ElementsAre(3))));
}

TEST(HolesToFillTest, OfCellsThatAreNotChosenThoseOfClustersThatReachChosenOnes) {
  EXPECT_THAT(HolesToFill(MadePlan(), {{0, 0}}),
              ElementsAre(Pair(CellId{0, 0}, ElementsAre(0)), Pair(CellId{1, 0}, ElementsAre(1))));
}

TEST(LastLayerOfTest, IsThatOfHolesWithoutWater) {
  Plan plan = MadePlan();
  EXPECT_EQ(LastLayerOf(plan, {0, 1}), 2);
  plan.holes[1].water = 0;
  EXPECT_EQ(LastLayerOf(plan, {0, 1}), 1);
}

// The hole of the first cell begins at vertices 0 and 1, of which 1 is an original one.
class SettledTest : public testing::Test {
 protected:
  SettledTest() {
    scene_.plan = MadePlan();
    scene_.plan.vertices.resize(2);
    scene_.plan.vertices[1].index = 7;
    scene_.plan.holes[0].segments = {{0, 1}, {1, 0}};
    scene_.holes_of = HolesToFill(scene_.plan, {});
  }

  const SceneSurvey survey_{Scene(), {}};
  PlannedScene scene_{survey_};
};

TEST_F(SettledTest, ACellCanBeFilledWhenItsNewVerticesHaveHeights) {
  EXPECT_FALSE(CanBeFilled(scene_, {0, 0}));
  EXPECT_THAT(HolesOfLayer(scene_, {0, 0}, 1), ElementsAre(0));
  EXPECT_THAT(HolesOfLayer(scene_, {0, 0}, 2), IsEmpty());
  scene_.heights.height[0] = 5;
  EXPECT_TRUE(CanBeFilled(scene_, {0, 0}));
  EXPECT_THAT(HolesOfLayer(scene_, {0, 0}, 1), IsEmpty());
}

TEST_F(SettledTest, ACellThatIsLeftCannotBeFilled) {
  scene_.heights.height[0] = 5;
  scene_.holes_of.erase({0, 0});
  EXPECT_FALSE(CanBeFilled(scene_, {0, 0}));
}

TEST_F(SettledTest, ComparesBordersBetweenChosenCellsWithHolesAlone) {
  const auto border = [](CellId a, CellId b) {
    BorderAudit audit;
    audit.a = a;
    audit.b = b;
    return audit;
  };
  scene_.plan.borders = {border({0, 0}, {1, 0}), border({1, 0}, {2, 0}), border({2, 0}, {3, 0})};
  WaveOptions options;
  EXPECT_EQ(BordersToCompare(scene_, options).size(), 2U) << "the last cell has no hole";
  options.chosen = {{1, 0}, {2, 0}};
  ASSERT_EQ(BordersToCompare(scene_, options).size(), 1U);
  EXPECT_EQ(BordersToCompare(scene_, options)[0].b, (CellId{2, 0}));
}

}  // namespace
}  // namespace tilemend
