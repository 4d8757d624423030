#include "worker/fill/shape/patch_quality.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// Originals at (0, 0), (10, 0), (20, 0.1) and (0.1, 0), a seam vertex at (10, 0.2), a new point at (5, 10).
CellHoles Vertices() {
  CellHoles cell;
  for (const Point3& p :
       {Point3(0, 0, 0), Point3(10, 0, 0), Point3(20, 0.1, 0), Point3(0.1, 0, 0), Point3(10, 0.2, 0)}) {
    cell.vertices.emplace_back();
    cell.vertices.back().position = p;
    cell.vertices.back().index = 7;
  }
  cell.vertices.back().index = -1;
  return cell;
}

QualityTally TallyOf(const Triangle& t) {
  HolePatch patch;
  patch.new_points = {{5, 10, 0}};
  patch.triangles = {t};
  return TallyQuality(Vertices(), {patch});
}

TEST(TallyQualityTest, AGoodTriangleIsNotPoor) {
  const QualityTally tally = TallyOf({0, 1, -1});
  EXPECT_EQ(tally.triangles, 1);
  EXPECT_GT(tally.least, 0.9);
  EXPECT_EQ(tally.poor, 0);
}

TEST(TallyQualityTest, ATriangleOfOriginalsIsForced) {
  const QualityTally tally = TallyOf({0, 1, 2});
  EXPECT_EQ(tally.poor, 1);
  EXPECT_EQ(tally.poor_forced, 1);
}

TEST(TallyQualityTest, ANeedleOnAnOriginalEdgeIsForced) {
  const QualityTally tally = TallyOf({0, 3, -1});
  EXPECT_EQ(tally.poor, 1);
  EXPECT_EQ(tally.poor_forced, 1);
}

TEST(TallyQualityTest, AFlatTriangleWithASeamVertexIsNotForced) {
  const QualityTally tally = TallyOf({0, 2, 4});
  EXPECT_EQ(tally.poor, 1);
  EXPECT_EQ(tally.poor_forced, 0);
}

TEST(TallyQualityTest, TakesAllPatchesTogether) {
  HolePatch one, two;
  one.new_points = {{5, 10, 0}};
  one.triangles = {{0, 1, -1}};
  two.triangles = {{0, 1, 2}};
  EXPECT_EQ(TallyQuality(Vertices(), {one, two}).triangles, 2);
}

}  // namespace
}  // namespace tilemend
