#include "coordinator/service/stage_results.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(SamplesOfTest, TakesTheColumnsOfAClusterTogether) {
  v1::SampleClusterOutput output;
  output.set_cluster(3);
  output.add_seam_vertex(7);
  output.add_height(1.5);
  output.add_laplacian(0.25);
  output.add_slope_x(0.5);
  output.add_slope_y(-0.5);
  const auto samples = SamplesOf(output);
  ASSERT_TRUE(samples.ok());
  EXPECT_EQ(samples->cluster, 3);
  ASSERT_EQ(samples->samples.size(), 1U);
  EXPECT_EQ(samples->samples[0].vertex, 7);
  EXPECT_EQ(samples->samples[0].slope, Point2(0.5, -0.5));
  output.add_height(2);
  EXPECT_FALSE(SamplesOf(output).ok());
}

TEST(SamplesOfTest, RefusesColumnsOfUnequalLengthOfALayer) {
  v1::SampleLayerOutput output;
  output.add_seam_vertex(7);
  EXPECT_FALSE(SamplesOf(output, {1, 2}).ok());
  output.add_height(1.5);
  ASSERT_TRUE(SamplesOf(output, {1, 2}).ok());
  EXPECT_EQ(SamplesOf(output, {1, 2})->front().cell, (CellId{1, 2}));
}

TEST(PatchesOfTest, RefusesAWayOfFillingThatItDoesNotKnow) {
  v1::FillOutput output;
  v1::PatchExtent& patch = *output.add_patches();
  patch.set_hole(4);
  patch.set_triangles(9);
  patch.set_way(static_cast<v1::FillWay>(1000));
  EXPECT_FALSE(PatchesOf(output).ok());
}

}  // namespace
}  // namespace tilemend
