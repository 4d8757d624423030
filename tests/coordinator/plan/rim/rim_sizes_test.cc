#include "coordinator/plan/rim/rim_sizes.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

Rim RimOfSizes(const std::vector<double>& sizes) {
  Rim rim;
  for (const double size : sizes) {
    rim.points.emplace_back();
    rim.points.back().size = size;
  }
  return rim;
}

TEST(RaiseSmallSizesTest, RaisesWhatTheLatticeCannotFollow) {
  Rim rim = RimOfSizes({1, 1, 1e-4, 0.1});
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_EQ(rim.points[0].size, 1);
  EXPECT_EQ(rim.points[2].size, 0x1p-4);
  EXPECT_EQ(rim.points[3].size, 0.1);
}

TEST(RaiseSmallSizesTest, KeepsTheSizesOfASurfaceThatIsFineThroughout) {
  Rim rim = RimOfSizes({0.001, 0.002, 0.003});
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_EQ(rim.points[0].size, 0.001);
  EXPECT_EQ(rim.points[1].size, 0.002);
}

// A run of edges of these lengths along a line; sizes as BuildRim gives them.
Rim RunOfEdges(const std::vector<double>& lengths) {
  Rim rim;
  rim.loops.emplace_back();
  double x = 0;
  const size_t n = lengths.size();
  for (size_t i = 0; i <= n; ++i) {
    rim.points.emplace_back();
    rim.points.back().position = Point3(x, 0, 0);
    rim.points.back().size = (lengths[i > 0 ? i - 1 : 0] + lengths[i < n ? i : n - 1]) / 2;
    if (i == n) break;
    rim.edges.push_back({static_cast<int32_t>(i), static_cast<int32_t>(i) + 1, {}});
    rim.loops[0].push_back(static_cast<int32_t>(i));
    x += lengths[i];
  }
  return rim;
}

TEST(RaiseSizesAtShortEdgesTest, RaisesThemWhereAShortRunLiesBetweenLongEdges) {
  Rim rim = RunOfEdges({1, 1, 0.01, 0.02, 1, 1});
  RaiseSizesAtShortEdges(rim);
  EXPECT_DOUBLE_EQ(rim.points[1].size, 1);
  EXPECT_DOUBLE_EQ(rim.points[2].size, 0.6);
  EXPECT_DOUBLE_EQ(rim.points[3].size, 0.59);
  EXPECT_DOUBLE_EQ(rim.points[4].size, 0.6);
}

TEST(RaiseSizesAtShortEdgesTest, KeepsThemOnLongRunsOfShortEdges) {
  Rim rim = RunOfEdges({1, 1, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 1, 1});
  RaiseSizesAtShortEdges(rim);
  EXPECT_DOUBLE_EQ(rim.points[3].size, 0.35);
  for (const int p : {4, 5, 6}) EXPECT_DOUBLE_EQ(rim.points[p].size, 0.25);
}

TEST(RaiseSizesAtShortEdgesTest, KeepsThemWhereEdgesAreOfSimilarLength) {
  Rim rim = RunOfEdges({1, 0.3, 1, 0.3, 1, 0.3});
  RaiseSizesAtShortEdges(rim);
  for (const int p : {1, 2, 3, 4, 5}) EXPECT_DOUBLE_EQ(rim.points[p].size, 0.65);
}

// The rim is at a height of 800 m, the new vertices on the edge of the area have none yet.
TEST(RaiseSizesAtShortEdgesTest, TakesEdgesOfTheAreaAsSeenFromAbove) {
  Rim rim = RunOfEdges({1, 1, 1, 1});
  for (const int p : {0, 1, 4}) rim.points[p].position.z() = 800;
  for (const int p : {2, 3}) rim.points[p].index = -1;
  for (const int e : {1, 2, 3}) rim.edges[e].area_edge = true;
  RaiseSizesAtShortEdges(rim);
  for (const RimPoint& p : rim.points) EXPECT_DOUBLE_EQ(p.size, 1);
}

TEST(RaiseSmallSizesTest, DoesNothingWithoutPoints) {
  Rim rim;
  RaiseSmallSizes(0x1p-10, rim);
  EXPECT_TRUE(rim.points.empty());
}

}  // namespace
}  // namespace tilemend
