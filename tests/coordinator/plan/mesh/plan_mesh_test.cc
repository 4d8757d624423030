#include "coordinator/plan/mesh/plan_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "tests/support/mesh_builders.h"
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
  EXPECT_TRUE(PlanMesh(small.input, {}).single_mesh);
}

TEST(PlanMeshTest, HasAnUpOnlyWhereWaterIsLookedFor) {
  const MeshReading read(Tube(16, 4, 1, 0, 2));
  PlanOptions options;
  options.water.find = false;
  EXPECT_FALSE(PlanMesh(read.input, options).upright);
  options.water.find = true;
  EXPECT_TRUE(PlanMesh(read.input, options).upright);
}

TEST(PlanMeshTest, LeavesTheOutlinesOfFlatPieces) {
  PlanOptions options;
  options.water.find = false;
  options.mesh.fill_outlines = true;
  TriMesh lone;
  lone.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  lone.triangles = {{0, 1, 2}};
  const MeshReading read(lone);
  const Plan plan = PlanMesh(read.input, options);
  EXPECT_THAT(plan.holes, testing::IsEmpty());
  ASSERT_EQ(plan.left.size(), 1u);
  EXPECT_TRUE(plan.left[0].is_hole);
  const MeshReading dome(SphereBelt(0, 60));
  EXPECT_EQ(PlanMesh(dome.input, options).holes.size(), 1u);
}

TEST(PlanMeshTest, KeepsIslandsInTheirHolesWhereOutlinesAreFilled) {
  const auto keep = [](int32_t i, int32_t j) {
    return i < 3 || i > 11 || j < 3 || j > 11 || (i > 5 && i < 8 && j > 5 && j < 8);
  };
  const MeshReading read(SquaresMesh(0, 15, 0, 15, keep));
  PlanOptions options;
  options.water.find = false;
  options.mesh.fill_outlines = true;
  const Plan plan = PlanMesh(read.input, options);
  ASSERT_EQ(plan.holes.size(), 1u);
  EXPECT_EQ(plan.holes[0].single, SingleType::kIsland);
  EXPECT_EQ(plan.left.size(), 1u) << "the outline of all, which is flat";
}

TEST(PlanMeshTest, GivesAnnularHolesTheAreaOfTheirBand) {
  const MeshReading read(TorusPart(32, 60, 10, 1, 0.97));
  PlanOptions options;
  options.water.find = false;
  const Plan plan = PlanMesh(read.input, options);
  ASSERT_EQ(plan.holes.size(), 1u);
  ASSERT_EQ(plan.holes[0].single, SingleType::kAnnular);
  const double around = 2 * std::numbers::pi;
  EXPECT_NEAR(plan.holes[0].area, around * around * 10 * 0.03, 0.2);
}

TEST(PlanMeshTest, SaysWhereEdgesAreThatFormNoLoop) {
  TriMesh fan;  // of three triangles at one edge
  fan.points = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, -9, 0}, {0, 0, 9}};
  fan.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  const MeshReading read(fan);
  const Plan plan = PlanMesh(read.input, {});
  const auto no_loop = std::ranges::find_if(plan.left, [](const LeftOpen& l) { return l.at.has_value(); });
  ASSERT_NE(no_loop, plan.left.end());
  EXPECT_TRUE(no_loop->is_hole);
  EXPECT_THAT(fan.points, testing::Contains(*no_loop->at));
}

TEST(PlanMeshTest, MeasuresDislocationsInTheUnitsOfTheMeshIfAsked) {
  // A slit as wide as the edges along it are long.
  const MeshReading read(SquaresMesh(0, 20, 0, 5, [](int32_t i, int32_t j) { return j != 2 || i < 3 || i > 16; }));
  PlanOptions options;
  options.water.find = false;
  const auto kind = [&] { return PlanMesh(read.input, options).holes.at(0).single; };
  EXPECT_EQ(kind(), SingleType::kSimple);
  options.mesh.dislocation_width = 1.5;
  EXPECT_EQ(kind(), SingleType::kDislocation);
}

}  // namespace
}  // namespace tilemend
