#include "coordinator/plan/overlap/joint_tiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "coordinator/plan/plan.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/overlapping_scene.h"
#include "tests/support/surveyed_scene.h"

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

// Tiles that are cut from one raster with a buffer of one square, where the surface is bent. The hole's rim has a
// diagonal through the grid corner (4, 4). The tile in the south-east has the triangle below it as well.
TEST(JointTilesBorderTest, ARimThroughAGridCornerCloses) {
  const auto is_there = [](int32_t i, int32_t j) { return i < 1 || i > 5 || j < 1 || j > (i > 3 ? 3 : 2); };
  const auto bent = [](double x, double y) { return 0.02 * x * y * y; };
  std::map<CellId, TriMesh> tiles;
  for (const int32_t col : {0, 1}) {
    for (const int32_t row : {0, 1}) {
      const int32_t i = 4 * col, j = 4 * row;
      TriMesh& tile = tiles[{col, row}] =
          Moved(SquaresMesh(i - 1, i + 5, j - 1, j + 5, is_there, bent),
                [](const Point3& p) { return Point3(p.x() + 0.5, p.y() + 0.5, p.z()); });
      std::erase_if(tile.triangles, [&](const Triangle& t) {
        const Point3 middle = (tile.points[t[0]] + tile.points[t[1]] + tile.points[t[2]]) / 3;
        return (col == 0 || row == 1) && (middle.head<2>() - Point2(4, 4)).cwiseAbs().maxCoeff() < 0.5 &&
               middle.x() > middle.y();
      });
    }
  }
  const Plan plan = PlanOf(SurveyScene({{0, 0}, {4, 4}}, std::move(tiles)));
  EXPECT_THAT(plan.left, IsEmpty());
  EXPECT_EQ(plan.clusters, 1);
  EXPECT_FALSE(plan.holes.empty());
}

}  // namespace
}  // namespace tilemend
