#include "worker/ground/join_rasters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tilemend {
namespace {

TEST(JoinRastersTest, TheLowestSurfaceCountsWhereTheyOverlap) {
  GroundRaster west = EmptyRaster(2, -3, 5, 3, 1), east = EmptyRaster(2, -1, 5, 2, 2);
  west.heights = {1, NAN, 3};
  east.heights = {2, 4, 5, NAN};
  const GroundRaster joined = JoinRasters(std::vector<GroundRaster>{west, {}, east});
  EXPECT_EQ(joined.square, 2);
  EXPECT_EQ(joined.col, -3);
  EXPECT_EQ(joined.cols, 4);
  EXPECT_EQ(joined.rows, 2);
  EXPECT_EQ(joined.heights[joined.IndexOf(-3, 5)], 1);
  EXPECT_TRUE(std::isnan(joined.heights[joined.IndexOf(-2, 5)]));
  EXPECT_EQ(joined.heights[joined.IndexOf(-1, 5)], 2);
  EXPECT_EQ(joined.heights[joined.IndexOf(0, 5)], 4);
  EXPECT_EQ(joined.heights[joined.IndexOf(-1, 6)], 5);
  EXPECT_TRUE(JoinRasters({}).empty());
  EXPECT_TRUE(JoinRasters(std::vector<GroundRaster>{{}}).empty());
}

}  // namespace
}  // namespace tilemend
