#include "coordinator/jobs/stage_results.h"

#include <gtest/gtest.h>

#include <tuple>

#include "common/rpc/stage_payloads.h"

namespace tilemend {
namespace {

TEST(SurveyedTileOfTest, HasTheRecordThatIsGivenOrTheOneOfItsMessage) {
  SurveyRecord sent, given;
  sent.triangle_count = 7;
  given.triangle_count = 8;
  v1::SurveyOutput output = ToProto(sent);
  output.set_digest("a digest");
  const auto decoded = SurveyedTileOf(output);
  ASSERT_TRUE(decoded.ok()) << decoded.status();
  EXPECT_EQ(decoded->record.triangle_count, 7);
  const auto taken = SurveyedTileOf(output, given);
  ASSERT_TRUE(taken.ok()) << taken.status();
  EXPECT_EQ(taken->record.triangle_count, 8);
  EXPECT_EQ(taken->digest, "a digest");
}

TEST(SamplesOfTest, TakesTheColumnsOfAClusterTogether) {
  v1::SampleClusterOutput output;
  output.set_cluster(3);
  output.add_seam_vertex(1);
  output.add_height(1.5);
  output.add_laplacian(0.25);
  output.add_slope_x(0.5);
  output.add_slope_y(-0.5);
  const AskedCluster asked{8, {5, 7}};
  const auto samples = SamplesOf(output, asked);
  ASSERT_TRUE(samples.ok());
  EXPECT_EQ(samples->cluster, 8);
  ASSERT_EQ(samples->samples.size(), 1U);
  EXPECT_EQ(samples->samples[0].vertex, 7);
  EXPECT_EQ(samples->samples[0].slope, Point2(0.5, -0.5));
  EXPECT_FALSE(SamplesOf(output, {8, {5}}).ok()) << "a vertex that was not asked for";
  output.add_height(2);
  EXPECT_FALSE(SamplesOf(output, asked).ok());
}

TEST(SamplesOfTest, RefusesColumnsOfUnequalLengthOfALayer) {
  v1::SampleLayerOutput output;
  output.add_seam_vertex(0);
  EXPECT_FALSE(SamplesOf(output, {1, 2}, {7}).ok());
  output.add_height(1.5);
  ASSERT_TRUE(SamplesOf(output, {1, 2}, {7}).ok());
  EXPECT_EQ(SamplesOf(output, {1, 2}, {7})->front().cell, (CellId{1, 2}));
  EXPECT_EQ(SamplesOf(output, {1, 2}, {7})->front().vertex, 7);
  EXPECT_FALSE(SamplesOf(output, {1, 2}, {}).ok());
}

TEST(PatchesOfTest, RefusesAWayOfFillingThatItDoesNotKnow) {
  v1::FillOutput output;
  v1::PatchExtent& patch = *output.add_patches();
  patch.set_hole(0);
  patch.set_triangles(9);
  patch.set_way(static_cast<v1::FillWay>(1000));
  EXPECT_FALSE(PatchesOf(output, {4}).ok());
  patch.set_way(v1::FILL_WAY_GROUND);
  *output.mutable_quality() = ToProto(QualityTally());
  ASSERT_TRUE(PatchesOf(output, {4}).ok());
  EXPECT_EQ(PatchesOf(output, {4})->patches.front().hole, 4);
  EXPECT_FALSE(PatchesOf(output, {4})->patches.front().rim_is_crossed);
  patch.set_rim_is_crossed(true);
  EXPECT_TRUE(PatchesOf(output, {4})->patches.front().rim_is_crossed);
  EXPECT_FALSE(PatchesOf(output, {}).ok()) << "a hole that was not asked for";
  patch.set_crossings(9);
  EXPECT_EQ(PatchesOf(output, {4})->patches.front().crossings, 9);
  patch.set_crossings(10);
  EXPECT_FALSE(PatchesOf(output, {4}).ok()) << "more than it has triangles";
}

TEST(PatchesOfTest, RefusesCountsThatNoPatchHas) {
  for (const auto& [cuts, creases, good] :
       {std::tuple(0, 6, true), {-1, 0, false}, {0, -1, false}, {0, 1 << 30, false}}) {
    v1::FillOutput output;
    v1::PatchExtent& patch = *output.add_patches();
    patch.set_triangles(9);
    patch.set_way(v1::FILL_WAY_GROUND);
    patch.set_loop_cuts(cuts);
    patch.set_creases(creases);
    *output.mutable_quality() = ToProto(QualityTally());
    EXPECT_EQ(PatchesOf(output, {4}).ok(), good) << cuts << ' ' << creases;
  }
}

}  // namespace
}  // namespace tilemend
