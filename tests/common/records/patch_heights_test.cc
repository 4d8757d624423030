#include "common/records/patch_heights.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

RimVertex Open(int32_t seam_vertex, int32_t follows = -1) {
  RimVertex v;
  v.seam_vertex = seam_vertex;
  v.follows = follows;
  v.height_known = false;
  return v;
}

TEST(TakeSampledHeightsTest, GivesTheMeanOnTheLattice) {
  CellHoles holes;
  holes.lattice_step = 0.25;
  holes.vertices = {Open(3), Open(4), Open(9, 4)};
  holes.vertices.push_back(Open(3));
  holes.vertices[3].height_known = true;
  holes.band.points.resize(4, Point3::Zero());
  const std::vector<int32_t> vertices = {3, 4, 3};
  const std::vector<double> heights = {1, 7, 1.3};
  TakeSampledHeights(vertices, heights, holes);
  EXPECT_EQ(holes.vertices[0].position.z(), 1.25);
  EXPECT_EQ(holes.vertices[1].position.z(), 7);
  EXPECT_EQ(holes.vertices[2].position.z(), 7) << "it follows 4";
  EXPECT_EQ(holes.vertices[3].position.z(), 0) << "its height was known";
  EXPECT_TRUE(holes.vertices[2].height_known);
  EXPECT_EQ(holes.band.points[0].z(), 1.25);
}

TEST(TakeSampledHeightsTest, LeavesOpenWhatHasNoSample) {
  CellHoles holes;
  holes.lattice_step = 0.25;
  holes.vertices = {Open(3)};
  TakeSampledHeights({}, {}, holes);
  EXPECT_FALSE(holes.vertices[0].height_known);
}

TEST(MoveSmoothedPointsTest, MovesPointsOfAllPatchesToTheMean) {
  std::vector<HolePatch> patches(3);
  patches[0].new_points = {{0, 0, 0}, {1, 0, 0}};
  patches[2].new_points = {{2, 0, 0}};
  const std::vector<std::vector<SmoothedPoint>> moves = {{{1, 4}, {2, 5}}, {{2, 6.1}}};
  MoveSmoothedPoints(moves, 0.5, patches);
  EXPECT_EQ(patches[0].new_points[0], Point3(0, 0, 0));
  EXPECT_EQ(patches[0].new_points[1], Point3(1, 0, 4));
  EXPECT_EQ(patches[2].new_points[0], Point3(2, 0, 5.5));
}

}  // namespace
}  // namespace tilemend
