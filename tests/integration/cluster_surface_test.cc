// The surface of a cluster from a bounded number of unknowns: the waves up to the cluster, and its solve, in memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "coordinator/waves/scene_waves.h"
#include "tests/support/scene_maker.h"
#include "tests/support/surveyed_scene.h"
#include "worker/fill/seam/sample_cluster.h"

namespace tilemend {
namespace {

// A lake five cells wide in 7 x 7 cells, all of one cluster.
class ClusterSurfaceTest : public testing::Test {
 protected:
  ClusterSurfaceTest() {
    const SurveyedScene scene = SurveyScene(MakeScene(Options()));
    WaveOptions options;
    options.find_objects = false;
    SceneWaves waves(scene.AsScene(), options);
    while (std::optional<SceneWork> work = waves.Next()) {
      if (const auto* survey = std::get_if<SurveyWork>(&*work)) {
        const CellId cell = survey->tile->cell;
        EXPECT_TRUE(waves.Take(SurveyInMemory(cell, scene.records.at(cell))).ok());
      } else if (auto* cluster = std::get_if<ClusterWork>(&*work)) {
        cluster_ = std::move(cluster->holes);
        ++clusters_;
      }
    }
  }

  static SceneMakerOptions Options() {
    SceneMakerOptions options;
    options.cols = options.rows = 7;
    options.cell_size = 20;
    options.spacing = 1;
    options.cut = Cut::kRagged;
    options.feature_size = 60;
    options.ellipses = {{{70, 70}, {48, 44}}};
    return options;
  }

  // Height by seam vertex.
  std::map<int32_t, double> Heights(int64_t most_unknowns) const {
    const auto surface = SampleCluster(cluster_, {}, most_unknowns);
    std::map<int32_t, double> heights;
    if (surface) {
      for (const SurfaceSample& s : surface->samples) heights[s.seam_vertex] = s.height;
    }
    return heights;
  }

  int clusters_ = 0;
  CellHoles cluster_;
};

TEST_F(ClusterSurfaceTest, SamplesEverySeamVertexOnce) {
  ASSERT_EQ(clusters_, 1);
  std::map<int32_t, int> seam_vertices;
  for (const RimVertex& v : cluster_.vertices) {
    if (v.seam_vertex >= 0) ++seam_vertices[v.seam_vertex];
  }
  EXPECT_GT(seam_vertices.size(), 100U);
  for (const int64_t most : {int64_t{1000000}, int64_t{600}}) {
    const auto surface = SampleCluster(cluster_, {}, most);
    ASSERT_TRUE(surface.has_value()) << most;
    std::map<int32_t, int> sampled;
    for (const SurfaceSample& s : surface->samples) ++sampled[s.seam_vertex];
    EXPECT_EQ(sampled, seam_vertices) << most;
  }
}

TEST_F(ClusterSurfaceTest, AFewUnknownsGiveAlmostTheSameSurface) {
  const std::map<int32_t, double> whole = Heights(1000000);
  ASSERT_FALSE(whole.empty());
  const auto [lowest, highest] =
      std::minmax_element(whole.begin(), whole.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const int64_t most : {1200, 600}) {
    const std::map<int32_t, double> coarse = Heights(most);
    ASSERT_EQ(coarse.size(), whole.size()) << most;
    double sum = 0;
    for (const auto& [v, height] : whole) sum += std::abs(height - coarse.at(v));
    EXPECT_LT(sum / static_cast<double>(whole.size()), 0.01 * (highest->second - lowest->second)) << most;
  }
}

TEST_F(ClusterSurfaceTest, FewerUnknownsThanGridCornersAreNotEnough) {
  EXPECT_FALSE(SampleCluster(cluster_, {}, 3).has_value());
}

}  // namespace
}  // namespace tilemend
