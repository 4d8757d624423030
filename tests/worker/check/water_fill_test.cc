#include "worker/check/water_fill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kLevel = 2;

// Level water of 6 x 6 squares, all of it added, whose boundary stands higher.
TriMesh Pond() {
  return SquaresMesh(
      0, 6, 0, 6, [](int32_t, int32_t) { return true; },
      [](double x, double y) { return x < 0.5 || x > 5.5 || y < 0.5 || y > 5.5 ? kLevel + 0.4 : kLevel; });
}

std::vector<bool> AllOf(const TriMesh& mesh) { return std::vector<bool>(mesh.triangles.size(), true); }

size_t VertexAt(const TriMesh& mesh, double x, double y) {
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.points[v].x() == x && mesh.points[v].y() == y) return v;
  }
  return 0;
}

const WaterHole kHole = {{3.2, 3.1}, kLevel, kLevel};

TEST(WaterFillTest, LevelWaterHasNothingOffItsLevel) {
  const auto findings = CheckWaterFills(Pond(), AllOf(Pond()), {kHole});
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_TRUE(findings[0].is_found);
  EXPECT_EQ(findings[0].vertices, 25);
  EXPECT_THAT(findings[0].off, IsEmpty());
}

TEST(WaterFillTest, AVertexTwoMillimetresTooHighIsFound) {
  TriMesh mesh = Pond();
  mesh.points[VertexAt(mesh, 2, 3)].z() += 0.002;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, SizeIs(1));
}

TEST(WaterFillTest, FallingWaterLiesBetweenItsLevels) {
  TriMesh mesh = Pond();
  mesh.points[VertexAt(mesh, 2, 3)].z() += 0.1;
  WaterHole river = kHole;
  river.highest = kLevel + 0.2;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {river})[0].off, IsEmpty());
}

TEST(WaterFillTest, AHoleWithoutAFillIsNotFound) {
  EXPECT_FALSE(CheckWaterFills(Pond(), AllOf(Pond()), {{{20, 20}, 2, 2}})[0].is_found);
}

TEST(WaterFillTest, AFillBesideItThatTouchesAtAVertexIsAnother) {
  TriMesh mesh = Pond();
  const auto corner = static_cast<int32_t>(VertexAt(mesh, 6, 6));
  const auto n = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{8, 6, 9}, {6, 8, 9}, {7, 7, 9}});
  mesh.triangles.push_back({corner, n, n + 2});
  mesh.triangles.push_back({corner, n + 2, n + 1});
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, IsEmpty());
}

TEST(WaterFillTest, OriginalVerticesInTheFillAreShore) {
  TriMesh mesh = Pond();
  const auto v = static_cast<int32_t>(VertexAt(mesh, 3, 3));
  mesh.points[static_cast<size_t>(v)].z() = 3;
  const auto n = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{3, 3.2, 6}, {3.2, 3, 6}});
  mesh.triangles.push_back({v, n, n + 1});
  std::vector<bool> added = AllOf(mesh);
  added.back() = false;
  EXPECT_THAT(CheckWaterFills(mesh, added, {kHole})[0].off, IsEmpty());
}

TEST(WaterFillTest, NewVerticesOnTheBoundaryMayBeOfASeam) {
  TriMesh mesh = Pond();
  const auto v = static_cast<int32_t>(VertexAt(mesh, 6, 3)), w = static_cast<int32_t>(VertexAt(mesh, 6, 4));
  mesh.points[static_cast<size_t>(w)].z() = kLevel;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off_at_seam, SizeIs(23)) << "of 24 on the boundary";
  const auto n = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{7, 3, 3}, {7, 4, 3}});
  mesh.triangles.push_back({v, n, n + 1});
  std::vector<bool> added = AllOf(mesh);
  added.back() = false;
  EXPECT_THAT(CheckWaterFills(mesh, added, {kHole})[0].off_at_seam, SizeIs(22)) << "one is of the shore";
}

TEST(WaterFillTest, AWallUpToTheBoundaryIsNoWater) {
  TriMesh mesh = Pond();
  mesh.points[VertexAt(mesh, 1, 3)].z() += 30;  // all triangles around it are steep, and some reach the boundary
  for (const double y : {2, 3, 4}) mesh.points[VertexAt(mesh, 0, y)].z() += 31;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, IsEmpty());
}

TEST(WaterFillTest, ASpikeBesideTheBoundaryIsNoWall) {
  TriMesh mesh = Pond();
  mesh.points[VertexAt(mesh, 1, 3)].z() += 30;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, SizeIs(1));
  mesh.points[VertexAt(mesh, 1, 3)].z() -= 60;
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, SizeIs(1));
}

// It stands above the boundary, as on a gable.
TEST(WaterFillTest, ThePeakOfAnUprightWallIsNoWater) {
  TriMesh mesh = Pond();
  Point3& peak = mesh.points[VertexAt(mesh, 1, 3)];
  peak = {0, 3, peak.z() + 30};
  EXPECT_THAT(CheckWaterFills(mesh, AllOf(mesh), {kHole})[0].off, IsEmpty());
}

}  // namespace
}  // namespace tilemend
