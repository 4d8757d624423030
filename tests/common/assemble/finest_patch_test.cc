#include "common/assemble/finest_patch.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

// A square of 4 m with a fan about its middle, and a second new vertex beside it at another height.
const TriMesh kSquare{{{0, 0, 5}, {4, 0, 5}, {4, 4, 5}, {0, 4, 5}}, {}};

FilePatch FanInSquare() {
  FilePatch patch;
  patch.new_points = {{2, 2, 1}, {10, 10, 1}, {10, 11, 2}};
  patch.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 5, 6}};
  patch.materials = {{0, "a"}, {4, "b"}};
  return patch;
}

TEST(FinestPatchTest, KnowsWhatIsAroundAVertex) {
  const FilePatch patch = FanInSquare();
  const FinestPatch finest(kSquare, patch);
  EXPECT_EQ(finest.At(1), Point3(4, 0, 5));
  EXPECT_EQ(finest.At(4), Point3(2, 2, 1));
  EXPECT_DOUBLE_EQ(finest.rim_edge(), 4);
  EXPECT_DOUBLE_EQ(finest.EdgeAt(0), std::sqrt(8));
  EXPECT_DOUBLE_EQ(finest.EdgeAt(1), 1);
  EXPECT_TRUE(finest.IsLevelAt(0));
  EXPECT_FALSE(finest.IsLevelAt(1)) << "the other end of its edge is higher";
  EXPECT_EQ(finest.RunAt(0), 0);
  EXPECT_EQ(finest.RunAt(2), 1);
}

TEST(NearestPositionTest, FindsTheNearestFromAnywhere) {
  const std::vector<Point3> positions = {{0, 0, 9}, {10, 0, 0}, {10, 0, 1}, {3, 7, 0}};
  const NearestPosition nearest(positions);
  for (double x = -30; x < 40; x += 1.7) {
    for (double y = -30; y < 40; y += 2.3) {
      int32_t best = 0;
      for (int32_t i = 1; i < 4; ++i) {
        if ((positions[i].head<2>() - Point2(x, y)).norm() < (positions[best].head<2>() - Point2(x, y)).norm())
          best = i;
      }
      EXPECT_EQ(nearest.Of({x, y}), best) << x << ", " << y;
    }
  }
  const std::vector<Point3> none;
  EXPECT_EQ(NearestPosition(none).Of({0, 0}), -1);
}

TEST(VertexThinningTest, OneASquare) {
  VertexThinning thinning(4, 0);
  EXPECT_TRUE(thinning.Take({0.5, 0.5}, 0.25));
  EXPECT_FALSE(thinning.Take({0.7, 0.9}, 0.25));
  EXPECT_TRUE(thinning.Take({1.1, 0.9}, 0.25));
  EXPECT_TRUE(thinning.Take({0.7, 0.9}, 0.6)) << "another step, another lattice";
  VertexThinning least(1, 2);
  EXPECT_TRUE(least.Take({0.1, 0.1}, 0.1));
  EXPECT_FALSE(least.Take({1.9, 1.9}, 0.1));
}

TEST(MedianOfTest, OfFewValues) {
  EXPECT_EQ(MedianOf({}), 0);
  EXPECT_EQ(MedianOf({3}), 3);
  EXPECT_EQ(MedianOf({9, 1, 3}), 3);
}

}  // namespace
}  // namespace tilemend
