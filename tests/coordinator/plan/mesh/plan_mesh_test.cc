#include "coordinator/plan/mesh/plan_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

TEST(PlanMeshTest, LaysALatticeThatSuitsTheEdges) {
  TriMesh mesh = Tube(16, 4, 1, 0, 2);
  const double step = PlanMesh(MeshReading(mesh).input, {}).lattice_step;
  EXPECT_LT(step, 1e-6);
  for (Point3& p : mesh.points) p *= 0x1p-30;
  const MeshReading small(mesh);
  EXPECT_EQ(PlanMesh(small.input, {}).lattice_step, step * 0x1p-30);
}

TEST(PlanMeshTest, HasAnUpOnlyWhereWaterIsLookedFor) {
  const MeshReading read(Tube(16, 4, 1, 0, 2));
  PlanOptions options;
  options.water.find = false;
  EXPECT_FALSE(PlanMesh(read.input, options).upright);
  options.water.find = true;
  EXPECT_TRUE(PlanMesh(read.input, options).upright);
}

}  // namespace
}  // namespace tilemend
