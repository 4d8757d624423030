#include "worker/fill/hole/facing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/folded_meshes.h"

namespace tilemend {
namespace {

CellHoles OnWall() { return WorkOfSheet(Disc(0, kWallHeight / 2, 3), FoldToBuilding, 0); }
CellHoles OnGround() { return WorkOfSheet(Disc(0, -5, 3), FoldToBuilding, 0); }
CellHoles OnRoofEdge() { return WorkOfSheet(Disc(0, kWallHeight, 6), FoldToBuilding, 0); }

// Calls use(hole) for the hole of a cell.
template <typename Use>
void With(const CellHoles& work, const Use& use) {
  const CellBand band(work);
  use(MakeLocalHole(work, band, work.holes[0]));
}

TEST(FacingTest, IsTheNormalOfAPlane) {
  With(OnWall(), [](const LocalHole& hole) {
    EXPECT_NEAR((FacingOf(hole).normalized() + Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
    EXPECT_NEAR((WidestView(hole) + Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  });
}

TEST(FacingTest, LooksAtAWallAndARoofFromBetween) {
  With(OnRoofEdge(), [](const LocalHole& hole) {
    const Eigen::Vector3d between = Eigen::Vector3d(0, -1, 1).normalized();
    EXPECT_LT((WidestView(hole) - between).norm(), 0.03) << WidestView(hole).transpose();
  });
}

TEST(FacingTest, TellsGroundFromWalls) {
  With(OnGround(), [](const LocalHole& hole) {
    EXPECT_TRUE(FacesUp(hole, ProjectionFrame::Upright()));
    EXPECT_TRUE(LiesInHeightField(hole, ProjectionFrame::Upright()));
    EXPECT_FALSE(IsSteep(hole));
  });
  With(OnWall(), [](const LocalHole& hole) {
    EXPECT_FALSE(FacesUp(hole, ProjectionFrame::Upright()));
    EXPECT_FALSE(LiesInHeightField(hole, ProjectionFrame::Upright()));
    EXPECT_FALSE(IsSteep(hole)) << "over its own plane it is flat";
  });
}

// A roof of two sides, each 10 degrees off level, in a mesh that may lie in any way.
TEST(FacingTest, IsSteepFromEightDegreesInAMeshThatMayLieInAnyWay) {
  for (const auto& [degrees, steep] : {std::pair(6.0, false), std::pair(10.0, true)}) {
    const double slope = std::tan(degrees * std::numbers::pi / 180);
    const auto roof = [&](const Point3& p) { return Point3(p.x(), p.y(), -slope * std::abs(p.y())); };
    CellHoles work = WorkOfSheet(Disc(0, 0, 4), roof, 0);
    With(work, [](const LocalHole& hole) { EXPECT_FALSE(IsSteep(hole)) << "over the ground"; });
    work.upright = false;
    With(work, [steep = steep](const LocalHole& hole) { EXPECT_EQ(IsSteep(hole), steep); });
  }
}

// Most of the way round a tube some of the surface is steep over any plane.
TEST(FacingTest, IsSteepAroundATank) {
  With(WorkOfSheet(IsInTankSlit, RollRoundTank(5), 0), [](const LocalHole& hole) { EXPECT_TRUE(IsSteep(hole)); });
}

}  // namespace
}  // namespace tilemend
