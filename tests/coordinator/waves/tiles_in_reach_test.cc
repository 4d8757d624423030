#include "coordinator/waves/tiles_in_reach.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;

// Two tiles of 10 m side by side, and a hole of 1 m in the western one whose centre is at (x, 5).
class TilesInReachTest : public ::testing::Test {
 protected:
  TilesInReachTest() {
    west_.lo = {0, 0, -1};
    west_.hi = {10, 10, 1};
    east_.lo = {10, 0, -1};
    east_.hi = {20, 10, 1};
    input_.cells = {{{0, 0}, &west_}, {{1, 0}, &east_}, {{2, 0}, nullptr}};
    plan_.borders.push_back({{0, 0}, {1, 0}, BorderKind::kExact, 5, 0, {}, {}});
    plan_.borders.push_back({{1, 0}, {2, 0}, BorderKind::kOpen, 0, 0, {}, {}});
  }

  std::set<CellId> Reached(double x) {
    CellHoles cell;
    cell.cell = {0, 0};
    for (const Point3& p : {Point3(x - 0.5, 4.5, 0), Point3(x + 0.5, 4.5, 0), Point3(x, 5.5, 0)}) {
      cell.vertices.emplace_back().position = p;
    }
    hole_.segments = {{0, 1}, {1, 2}, {2, 0}};
    cell.holes.push_back(hole_);
    return TilesInReach(cell, plan_, input_);
  }

  SurveyRecord west_, east_;
  PlanInput input_;
  Plan plan_;
  CellHole hole_;
};

TEST_F(TilesInReachTest, AHoleFarFromTheBorderReachesItsOwnTileAlone) {
  EXPECT_THAT(Reached(5), ElementsAre(CellId{0, 0}));
}

TEST_F(TilesInReachTest, AHoleBesideTheBorderReachesTheNeighbour) {
  EXPECT_THAT(Reached(9), ElementsAre(CellId{0, 0}, CellId{1, 0}));
}

TEST_F(TilesInReachTest, TilesThatOverlapAreFilledEachForItself) {
  plan_.borders[0].kind = BorderKind::kOverlap;
  EXPECT_THAT(Reached(9), ElementsAre(CellId{0, 0}));
}

TEST_F(TilesInReachTest, OpenHolesAndWaterMayRunIntoThemToo) {
  hole_.open = true;
  EXPECT_THAT(Reached(9), ElementsAre(CellId{0, 0}, CellId{1, 0}));
  hole_.open = false;
  hole_.level = 3;
  EXPECT_THAT(Reached(9), ElementsAre(CellId{0, 0}, CellId{1, 0}));
}

TEST_F(TilesInReachTest, ACellWithoutATileIsNotReached) {
  input_.cells[{0, 0}] = nullptr;
  EXPECT_THAT(Reached(9), ElementsAre(CellId{1, 0}));
}

}  // namespace
}  // namespace tilemend
