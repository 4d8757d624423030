#include "coordinator/plan/mesh/loop_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

TEST(GroupLoopsTest, PutsIslandsIntoTheSmallestHoleThatTheyLieIn) {
  const auto keep = [](int32_t i, int32_t j) {
    return i < 3 || i > 11 || j < 3 || j > 11 || (i > 5 && i < 8 && j > 5 && j < 8);
  };
  const MeshReading read(SquaresMesh(0, 15, 0, 15, keep));
  EXPECT_THAT(read.Kinds(), ElementsAre(SingleType::kIsland));
  EXPECT_EQ(read.groups.outlines.size(), 1u);
}

TEST(GroupLoopsTest, TakesATubeWithAGapForOneAnnularHole) {
  TriMesh mesh = SphereBelt(0, 70);
  AddMesh(SphereBelt(95, 150), mesh);
  const MeshReading read(mesh);
  EXPECT_THAT(read.Kinds(), testing::UnorderedElementsAre(SingleType::kAnnular, SingleType::kSimple));
  EXPECT_THAT(MeshReading(TorusPart(16, 40, 5, 1, 0.95)).Kinds(), ElementsAre(SingleType::kAnnular));
}

// Nearest places are corners as often as not, and boxes depend on the axes.
TEST(GroupLoopsTest, FindsTheSameHoweverTheMeshIsTurned) {
  for (const double kept : {0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95}) {
    const TriMesh mesh = TorusPart(15, 60, 4, 1, kept);
    const std::vector<SingleType> kinds = MeshReading(mesh).Kinds();
    for (int turn = 1; turn < 12; ++turn) {
      const Eigen::AngleAxisd rotation(0.5 * turn, Eigen::Vector3d(1, turn % 3, 0.3 * turn).normalized());
      TriMesh turned = mesh;
      for (Point3& p : turned.points) p = rotation * p;
      EXPECT_EQ(MeshReading(turned).Kinds(), kinds) << kept << ", " << turn;
    }
  }
}

}  // namespace
}  // namespace tilemend
