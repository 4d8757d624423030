#include "coordinator/plan/mesh/mesh_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

TEST(ReadMeshLoopsTest, TellsHolesTubesAndSheetsApartByTheirTurn) {
  const auto turn = [](const TriMesh& mesh) { return MeshReading(mesh).loops[0].Turn(); };
  EXPECT_NEAR(turn(WithoutHole(BoxMesh(6), [](const Point3& p) { return (p - Point3(3, 3, 0)).norm() < 1.2; })), 1,
              1e-9);
  EXPECT_NEAR(turn(SquaresMesh(0, 3, 0, 3, Everywhere)), -1, 1e-9);
  EXPECT_NEAR(turn(Tube(16, 4, 1, 0, 2)), 0, 1e-9);
}

TEST(ReadMeshLoopsTest, FindsContinuousHoles) {
  // Two squares that touch at a corner, and one that does not.
  const auto keep = [](int32_t i, int32_t j) {
    return !(i == 2 && j == 2) && !(i == 3 && j == 3) && !(i == 7 && j == 7);
  };
  const MeshReading read(SquaresMesh(0, 10, 0, 10, keep));
  ASSERT_EQ(read.loops.size(), 4u);
  EXPECT_EQ(CountContinuous(read.loops), 1);
  EXPECT_EQ(std::ranges::count_if(read.loops, &MeshLoop::touches), 2);
}

}  // namespace
}  // namespace tilemend
