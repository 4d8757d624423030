// Small scenes, and results of their work that are made up.
#ifndef TILEMEND_TESTS_COORDINATOR_WAVES_MADE_UP_RESULTS_H_
#define TILEMEND_TESTS_COORDINATOR_WAVES_MADE_UP_RESULTS_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "coordinator/waves/scene_waves.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {

// Three by three cells of four squares; the hole reaches into all of them. The one in the middle has no tile.
inline SurveyedScene Lake() {
  return PictureScene({"############", "############", "############", "###......###", "###......###", "###......###",
                       "###......###", "###......###", "###......###", "############", "############", "############"},
                      4);
}

// A hole over the first two cells, a smaller one over the second and the third, and a closed one in the fourth.
inline SurveyedScene SeveralHoles() {
  return PictureScene({"################", "##....#..####.##", "##....##########", "################"}, 4);
}

inline WaveOptions Dry(Surface surface = Surface::kThinPlate) {
  WaveOptions options;
  options.surface = surface;
  options.plan.water.find = false;
  return options;
}

struct Namer {
  std::string operator()(const MeasureWork& w) const { return absl::StrCat("measure ", ToString(w.tile->cell)); }
  std::string operator()(const SurveyWork& w) const { return absl::StrCat("survey ", ToString(w.tile->cell)); }
  std::string operator()(const GroundWork& w) const { return absl::StrCat("ground ", ToString(w.cell)); }
  std::string operator()(const ClusterWork& w) const { return absl::StrCat("cluster ", w.cluster); }
  std::string operator()(const LayerWork& w) const { return absl::StrCat("layer ", ToString(w.holes.cell)); }
  std::string operator()(const FillWork& w) const { return absl::StrCat("fill ", ToString(w.holes.cell)); }
  std::string operator()(const SmoothWork& w) const {
    return absl::StrCat("smooth ", ToString(w.cells[0]), " ", ToString(w.cells[1]));
  }
  std::string operator()(const AssembleWork& w) const { return absl::StrCat("assemble ", ToString(w.tile->cell)); }
};
inline std::string NameOf(const SceneWork& work) { return std::visit(Namer{}, work); }

// Gives results that are made up: every height is that of its seam vertex's number.
class Stages {
 public:
  Stages(SceneWaves& waves, const SurveyedScene& scene) : waves_(waves), scene_(scene) {}
  bool cluster_has_surface = true;

  void Do(const SceneWork& work) { std::visit(*this, work); }

  void operator()(const MeasureWork& w) {
    EXPECT_TRUE(waves_.Take(TileLevels{w.tile->cell, std::vector<HeightTally>(w.polygons.size())}).ok());
  }
  void operator()(const SurveyWork& w) {
    EXPECT_TRUE(waves_.Take(SurveyInMemory(w.tile->cell, scene_.records.at(w.tile->cell))).ok());
  }
  void operator()(const GroundWork& w) {
    const size_t vertices = scene_.records.at(w.cell).vertices.size();
    EXPECT_TRUE(waves_.Take(CellGround{w.cell, {std::vector<bool>(vertices), std::vector<float>(vertices)}}).ok());
  }
  void operator()(const ClusterWork& w) {
    ClusterSamples result{w.cluster, {}, {}};
    for (const RimVertex& v : w.holes.vertices) {
      if (cluster_has_surface && v.seam_vertex >= 0)
        result.samples.push_back({v.seam_vertex, 1.0 * v.seam_vertex, 0.5});
    }
    EXPECT_TRUE(waves_.Take(result).ok());
  }
  void operator()(const LayerWork& w) {
    std::vector<SeamSample> samples;
    for (const RimVertex& v : w.holes.vertices) {
      if (!v.height_known) samples.push_back({w.holes.cell, v.seam_vertex, 1.0 * v.seam_vertex});
    }
    EXPECT_THAT(samples, testing::Not(testing::IsEmpty())) << "a layer without an open height";
    EXPECT_TRUE(waves_.Take(LayerSamples{samples}).ok());
  }
  void operator()(const FillWork& w) {
    CellPatches result;
    for (const RimVertex& v : w.sampled.value_or(CellHoles()).vertices) {
      if (!v.height_known) result.samples.push_back({w.holes.cell, v.seam_vertex, 1.0 * v.seam_vertex});
    }
    for (const RimVertex& v : w.holes.vertices) {
      EXPECT_TRUE(v.height_known || w.sampled) << "filled before its seams are settled";
    }
    for (const CellHole& hole : w.holes.holes) result.patches.push_back({hole.id, "", 1, 2, {}});
    EXPECT_TRUE(waves_.Take(CellFill{w.holes.cell, result}).ok());
  }
  void operator()(const SmoothWork& w) {
    std::vector<double> heights = w.heights;
    for (double& height : heights) height += 100;
    EXPECT_TRUE(waves_.Take(SmoothedSeam{w.cells, w.vertices, heights}).ok());
  }
  void operator()(const AssembleWork&) { EXPECT_TRUE(waves_.Take(TileWritten{}).ok()); }

 private:
  SceneWaves& waves_;
  const SurveyedScene& scene_;
};

inline std::vector<SceneWork> AllNow(SceneWaves& waves) {
  std::vector<SceneWork> all;
  while (std::optional<SceneWork> work = waves.Next()) all.push_back(*std::move(work));
  return all;
}

inline std::vector<std::string> NamesOf(const std::vector<SceneWork>& works) {
  std::vector<std::string> names;
  for (const SceneWork& work : works) names.push_back(NameOf(work));
  return names;
}

inline void DoAll(const std::vector<SceneWork>& works, Stages& stages) {
  for (const SceneWork& work : works) stages.Do(work);
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COORDINATOR_WAVES_MADE_UP_RESULTS_H_
