#include "coordinator/waves/scene_waves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tests/coordinator/waves/made_up_results.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(SceneWavesTest, SurveysTheTilesFirst) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  EXPECT_THAT(NamesOf(AllNow(waves)), AllOf(SizeIs(8), Each(StartsWith("survey "))));
  EXPECT_FALSE(waves.done());
  EXPECT_EQ(waves.phase(), "survey");
}

TEST(SceneWavesTest, FillsAClusterOnlyWhenItsSurfaceIsKnown) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> cluster = AllNow(waves);
  ASSERT_THAT(NamesOf(cluster), ElementsAre("cluster 0"));
  EXPECT_THAT(std::get<ClusterWork>(cluster[0]).holes.holes, SizeIs(9));
  DoAll(cluster, stages);
  const std::vector<SceneWork> fills = AllNow(waves);
  EXPECT_THAT(NamesOf(fills), AllOf(SizeIs(9), Each(StartsWith("fill "))));
  DoAll(fills, stages);
  const std::vector<SceneWork> assembles = AllNow(waves);
  EXPECT_THAT(NamesOf(assembles), AllOf(SizeIs(9), Each(StartsWith("assemble "))));
  EXPECT_FALSE(waves.done());
  DoAll(assembles, stages);
  EXPECT_THAT(AllNow(waves), IsEmpty());
  EXPECT_TRUE(waves.done());
  EXPECT_EQ(waves.cells().done, 9);
  EXPECT_EQ(waves.outcome().sizes.size(), 9U);
}

TEST(SceneWavesTest, BeginsWithTheLargestClusterAndFillsMeanwhileWhatNeedsNone) {
  const SurveyedScene scene = SeveralHoles();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> works = AllNow(waves);
  const auto size = [&](int i) { return std::get<ClusterWork>(works[i]).holes.vertices.size(); };
  ASSERT_THAT(NamesOf(works), ElementsAre(StartsWith("cluster "), StartsWith("cluster "), "fill +003_+000"));
  EXPECT_GT(size(0), size(1));
  stages.Do(works[1]);
  EXPECT_THAT(NamesOf(AllNow(waves)), ElementsAre("fill +002_+000")) << "the other cluster is not known yet";
}

TEST(SceneWavesTest, SamplesLayerByLayerWhatHasNoSurface) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  stages.cluster_has_surface = false;
  for (int wave = 0; wave < 2; ++wave) DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> first = AllNow(waves);
  EXPECT_THAT(NamesOf(first), AllOf(Each(StartsWith("layer ")), Not(Contains("layer +001_+001"))));
  EXPECT_EQ(waves.phase(), "sample layer 1 of 2");
  DoAll(first, stages);
  // The hole in the middle has seams alone, and the first layer has settled them all.
  const std::vector<SceneWork> fills = AllNow(waves);
  EXPECT_THAT(NamesOf(fills), AllOf(SizeIs(9), Each(StartsWith("fill "))));
}

TEST(SceneWavesTest, WangFillsLayerByLayerAndSmoothsLast) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry(Surface::kWang));
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> first = AllNow(waves);
  EXPECT_THAT(NamesOf(first), AllOf(SizeIs(8), Each(StartsWith("fill ")), Not(Contains("fill +001_+001"))));
  for (const SceneWork& work : first) EXPECT_TRUE(std::get<FillWork>(work).sampled);
  EXPECT_EQ(waves.phase(), "fill layer 1 of 2");
  DoAll(first, stages);
  const std::vector<SceneWork> second = AllNow(waves);
  ASSERT_THAT(NamesOf(second), ElementsAre("fill +001_+001"));
  for (const RimVertex& v : std::get<FillWork>(second[0]).holes.vertices) EXPECT_TRUE(v.height_known);
  DoAll(second, stages);
  // Eight cells of layer 1 in a ring; the seams to the one in the middle are between layers.
  const std::vector<SceneWork> seams = AllNow(waves);
  EXPECT_THAT(NamesOf(seams),
              AllOf(SizeIs(8), Each(StartsWith("smooth ")), Not(Contains("smooth +001_+000 +001_+001"))));
  std::set<std::pair<CellId, int32_t>> numbers;
  for (const SceneWork& work : seams) {
    numbers.insert({std::get<SmoothWork>(work).cells[0], std::get<SmoothWork>(work).number});
  }
  EXPECT_THAT(numbers, SizeIs(8)) << "they tell the seams of a cell apart";
  const auto before = waves.heights().height;
  DoAll(seams, stages);
  const std::vector<SceneWork> assembles = AllNow(waves);
  EXPECT_THAT(NamesOf(assembles), AllOf(SizeIs(9), Each(StartsWith("assemble "))));
  EXPECT_NE(waves.heights().height, before);
  for (const SceneWork& work : assembles) {
    for (const RimVertex& v : std::get<AssembleWork>(work).holes.value_or(CellHoles()).vertices) {
      const double settled = v.index < 0 ? waves.heights().height.at(v.seam_vertex) : v.position.z();
      EXPECT_EQ(v.position.z(), settled);
    }
  }
}

// Around the corner of four cells each seam moves the vertex that all have in common.
TEST(SceneWavesTest, SmoothsForChosenCellsAllThatMovesTheirVertices) {
  const SurveyedScene scene = PictureScene({"############", "############", "##....######", "##....######",  //
                                            "##....######", "##....######", "############", "############"},
                                           4);
  const auto smoothed = [&](std::set<CellId> chosen) {
    WaveOptions options = Dry(Surface::kWang);
    options.chosen = std::move(chosen);
    SceneWaves waves(scene.AsScene(), options);
    Stages stages(waves, scene);
    std::vector<std::string> names;
    for (std::vector<SceneWork> work = AllNow(waves); !work.empty(); work = AllNow(waves)) {
      for (const std::string& name : NamesOf(work)) {
        if (name.starts_with("smooth ")) names.push_back(name);
      }
      DoAll(work, stages);
    }
    return std::pair(names, waves.heights().height);
  };
  const auto all = smoothed({});
  EXPECT_THAT(all.first, SizeIs(4));
  EXPECT_EQ(smoothed({{0, 0}}), all);
  EXPECT_THAT(smoothed({{2, 0}}).first, IsEmpty());
}

TEST(SceneWavesTest, SmoothsNothingWithGammaZero) {
  const SurveyedScene scene = Lake();
  WaveOptions options = Dry(Surface::kWang);
  options.wang.seam_smoothing = 0;
  SceneWaves waves(scene.AsScene(), options);
  Stages stages(waves, scene);
  for (int wave = 0; wave < 3; ++wave) DoAll(AllNow(waves), stages);
  EXPECT_THAT(NamesOf(AllNow(waves)), Each(StartsWith("assemble ")));
}

TEST(SceneWavesTest, SettlesTheSameHeightsInWhateverOrderResultsCome) {
  const SurveyedScene scene = SeveralHoles();
  std::vector<SeamHeights> heights;
  std::vector<std::vector<std::string>> outcomes;
  for (const bool backwards : {false, true}) {
    SceneWaves waves(scene.AsScene(), Dry());
    Stages stages(waves, scene);
    std::vector<std::string> done;
    std::vector<SceneWork> open = AllNow(waves);
    while (!open.empty()) {
      const auto next = backwards ? open.end() - 1 : open.begin();
      done.push_back(NameOf(*next));
      stages.Do(*next);
      open.erase(next);
      for (SceneWork& work : AllNow(waves)) open.push_back(std::move(work));
    }
    EXPECT_TRUE(waves.done());
    std::sort(done.begin(), done.end());
    outcomes.push_back(std::move(done));
    heights.push_back(waves.heights());
  }
  EXPECT_EQ(outcomes[0], outcomes[1]);
  EXPECT_EQ(heights[0].height, heights[1].height);
  EXPECT_EQ(heights[0].laplacian, heights[1].laplacian);
}

TEST(SceneWavesTest, AsksForNoHeightsOfWater) {
  const SurveyedScene scene = Lake();
  WaveOptions options;
  options.plan.water.areas = {{true, {{{{-1, -1}, {13, -1}, {13, 13}, {-1, 13}}}}}};
  SceneWaves waves(scene.AsScene(), options);
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  EXPECT_THAT(NamesOf(AllNow(waves)), AllOf(SizeIs(9), Each(StartsWith("fill "))));
  EXPECT_EQ(waves.plan().water.size(), 1U);
}

TEST(SceneWavesTest, EndsWithThePlanIfThatIsAll) {
  const SurveyedScene scene = Lake();
  WaveOptions options = Dry();
  options.plan_only = true;
  std::vector<std::string> steps;
  SceneWaves waves(scene.AsScene(), options, [&](std::string_view step) { steps.emplace_back(step); });
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  EXPECT_THAT(AllNow(waves), IsEmpty());
  EXPECT_TRUE(waves.done());
  EXPECT_EQ(waves.plan().holes.size(), 9U);
  EXPECT_THAT(steps, ElementsAre("survey", "ground", "plan"));
}

TEST(SceneWavesTest, TellsTheEndOfEveryStepOnce) {
  const SurveyedScene scene = Lake();
  std::vector<std::string> steps;
  SceneWaves waves(scene.AsScene(), Dry(), [&](std::string_view step) { steps.emplace_back(step); });
  Stages stages(waves, scene);
  while (const std::optional<SceneWork> work = waves.Next()) stages.Do(*work);
  EXPECT_THAT(steps, ElementsAre("survey", "ground", "plan", "sample", "fill", "assemble"));
}

// So "fill" has the time of the fills that follow, which is most of it.
TEST(SceneWavesTest, SamplingEndsWhenTheLastClusterIsKnown) {
  const SurveyedScene scene = Lake();
  std::vector<std::string> steps;
  SceneWaves waves(scene.AsScene(), Dry(), [&](std::string_view step) { steps.emplace_back(step); });
  Stages stages(waves, scene);
  while (const std::optional<SceneWork> work = waves.Next()) {
    if (std::holds_alternative<FillWork>(*work)) {
      EXPECT_EQ(steps.back(), "sample");
    } else if (std::holds_alternative<ClusterWork>(*work)) {
      EXPECT_EQ(steps.back(), "plan");
    }
    stages.Do(*work);
  }
}

TEST(SceneWavesTest, ATileThatIsNotWrittenHasNoQuality) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  while (const std::optional<SceneWork> work = waves.Next()) {
    if (const auto* fill = std::get_if<FillWork>(&*work)) {
      CellPatches patches;
      for (const CellHole& hole : fill->holes.holes) patches.patches.push_back({hole.id, "", 1, 1});
      patches.quality.Add(fill->holes.cell == CellId{2, 2} ? 0.25 : 0.5, false);
      EXPECT_TRUE(waves.Take(CellFill{fill->holes.cell, patches}).ok());
    } else if (NameOf(*work) == "assemble +002_+002") {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kTile, {2, 2}, "the disk broke"}).ok());
    } else {
      stages.Do(*work);
    }
  }
  EXPECT_EQ(waves.outcome().Quality().triangles, 8);
  EXPECT_EQ(waves.outcome().Quality().least, 0.5);
}

TEST(SceneWavesTest, LostGroundAndSeamsLeaveNothingOpen) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry(Surface::kWang));
  Stages stages(waves, scene);
  while (const std::optional<SceneWork> work = waves.Next()) {
    if (const auto* ground = std::get_if<GroundWork>(&*work)) {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kGround, ground->cell, "lost"}).ok());
    } else if (const auto* smooth = std::get_if<SmoothWork>(&*work)) {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kSeam, smooth->cells[0], "lost"}).ok());
    } else {
      stages.Do(*work);
    }
  }
  EXPECT_GE(waves.outcome().impaired.size(), 8U);
  EXPECT_TRUE(waves.outcome().unwritten.empty());
  EXPECT_TRUE(waves.outcome().failures.empty());
}

TEST(SceneWavesTest, WritesNoTileForACellThatNothingFills) {
  SurveyedScene scene = PictureScene({"####....", "####....", "####....", "####...."}, 4);
  scene.area_known = false;  // what reaches the rim of the area stays open
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  EXPECT_THAT(NamesOf(AllNow(waves)), ElementsAre("assemble +000_+000"));
  EXPECT_EQ(waves.cells().done, 1);
}

TEST(SceneWavesTest, GoesOnWithoutACellThatIsLeft) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  std::vector<std::string> names;
  while (const std::optional<SceneWork> work = waves.Next()) {
    names.push_back(NameOf(*work));
    if (names.back() == "fill +001_+001") {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kHoles, {1, 1}, "the worker broke"}).ok());
    } else if (names.back() == "assemble +002_+002") {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kTile, {2, 2}, "the disk broke"}).ok());
    } else {
      stages.Do(*work);
    }
  }
  EXPECT_TRUE(waves.done());
  EXPECT_EQ(waves.outcome().sizes.size(), 7U);
  ASSERT_EQ(waves.outcome().failures.size(), 2U) << "what is not written is not filled";
  EXPECT_EQ(waves.outcome().failures.begin()->second, "the worker broke");
  EXPECT_EQ(waves.outcome().failures.rbegin()->second, "the disk broke");
  EXPECT_THAT(names, Not(Contains("assemble +001_+001"))) << "the cell has no tile, and now no patch";
  ASSERT_EQ(waves.outcome().unwritten.size(), 1U);
  EXPECT_EQ(waves.outcome().unwritten[0].reason, "the tile is not written: the disk broke");
  EXPECT_EQ(waves.cells().done, 8);
}

// The cluster's surface is lost with one of its cells: the others get their heights from the layers.
TEST(SceneWavesTest, FillsTheRestOfAClusterWhoseSurfaceIsLost) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  while (const std::optional<SceneWork> work = waves.Next()) {
    if (const auto* cluster = std::get_if<ClusterWork>(&*work)) {
      EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kHoles, cluster->holes.cell, "the solver broke"}).ok());
    } else {
      stages.Do(*work);
    }
  }
  EXPECT_EQ(waves.outcome().failures.size(), 1U);
  EXPECT_EQ(waves.outcome().sizes.size(), 8U);
}

TEST(SceneWavesTest, RefusesResultsThatNameNothing) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  ASSERT_THAT(AllNow(waves), SizeIs(1));
  const auto vertices = static_cast<int32_t>(waves.plan().vertices.size());
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(ClusterSamples{7, {}, {}})));
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(ClusterSamples{0, {{vertices, 0, 0}}, {}})));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(ClusterSamples{0, {{0, nan, 0}}, {}})));
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(ClusterSamples{0, {{0, 0, nan}}, {}})));
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(LayerSamples{{{{0, 0}, -1, 0}}})));
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(LayerSamples{{{{0, 0}, 0, nan}}})));
  EXPECT_TRUE(absl::IsInvalidArgument(waves.Take(CellFill{{0, 0}, {{{9, "", 1, 1, {}}}, {}}})));
  EXPECT_TRUE(waves.outcome().sizes.empty());
}

TEST(SceneWavesTest, KeepsTheTensionsAndTheQualityThatWereFound) {
  const SurveyedScene scene = Lake();
  SceneWaves waves(scene.AsScene(), Dry());
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  ASSERT_THAT(AllNow(waves), SizeIs(1));
  ASSERT_TRUE(waves.Take(ClusterSamples{0, {}, HoldOut{0.25, 1, 2, 3}}).ok());
  EXPECT_EQ(waves.outcome().of_clusters.at(0).tension, 0.25);
  EXPECT_EQ(waves.heights().tension.at(0), 0.25);
  CellPatches patches{{{3, "no way", 0, 0, HoldOut{0.5, 1, 2, 3}}}, {}};
  patches.quality.Add(0.5, false);
  ASSERT_TRUE(waves.Take(CellFill{{0, 0}, patches}).ok());
  EXPECT_EQ(waves.outcome().of_holes.at(3).tension, 0.5);
  EXPECT_EQ(waves.outcome().failures.at(3), "no way");
  EXPECT_EQ(waves.outcome().Quality().triangles, 1);
}

TEST(SceneWavesTest, TakesASingleMeshWithoutAGrid) {
  const SurveyedScene scene = PictureScene({"######", "##.#.#", "######", "######", "######", "######"}, 6);
  WaveOptions options = Dry();
  options.single_mesh = true;
  SceneWaves waves(scene.AsScene(), options);
  Stages stages(waves, scene);
  std::vector<std::string> names;
  while (const std::optional<SceneWork> work = waves.Next()) {
    names.push_back(NameOf(*work));
    if (const auto* fill = std::get_if<FillWork>(&*work)) {
      EXPECT_THAT(fill->holes.holes, SizeIs(2));
    }
    if (const auto* assemble = std::get_if<AssembleWork>(&*work)) {
      EXPECT_EQ(assemble->tile_vertices, std::ssize(scene.tiles.at({0, 0}).points));
      EXPECT_TRUE(assemble->float32);
    }
    stages.Do(*work);
  }
  EXPECT_THAT(names, ElementsAre("survey +000_+000", "fill +000_+000", "assemble +000_+000"));
  EXPECT_EQ(waves.plan().outer_rims, 1);
}

}  // namespace
}  // namespace tilemend
