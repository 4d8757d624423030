// Tiles that are assembled beside other work.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/coordinator/waves/made_up_results.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

TEST(EarlyWritesTest, WritesEarlyBesideOtherWork) {
  const SurveyedScene scene = SeveralHoles();
  WaveOptions options = Dry();
  options.write_early = true;
  SceneWaves waves(scene.AsScene(), options);
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> works = AllNow(waves);
  ASSERT_THAT(NamesOf(works), ElementsAre(StartsWith("cluster "), StartsWith("cluster "), "fill +003_+000"));
  stages.Do(works[2]);
  const std::vector<SceneWork> beside = AllNow(waves);
  EXPECT_THAT(NamesOf(beside), ElementsAre("assemble +003_+000"));
  DoAll(beside, stages);
  EXPECT_EQ(waves.cells().done, 1);
  stages.Do(works[0]);
  stages.Do(works[1]);
  const std::vector<SceneWork> fills = AllNow(waves);
  EXPECT_THAT(NamesOf(fills), AllOf(SizeIs(3), Each(StartsWith("fill "))));
  DoAll(fills, stages);
  const std::vector<SceneWork> rest = AllNow(waves);
  EXPECT_THAT(NamesOf(rest), ElementsAre("assemble +000_+000", "assemble +001_+000", "assemble +002_+000"));
  EXPECT_FALSE(waves.done());
  DoAll(rest, stages);
  EXPECT_THAT(AllNow(waves), IsEmpty());
  EXPECT_TRUE(waves.done());
  EXPECT_EQ(waves.cells().done, 4);
}

TEST(EarlyWritesTest, WritesTilesWithoutHolesWhileOthersAreFilled) {
  // The fourth cell has none.
  const SurveyedScene scene =
      PictureScene({"################", "##....#..#######", "##....##########", "################"}, 4);
  WaveOptions options = Dry();
  options.write_early = true;
  SceneWaves waves(scene.AsScene(), options);
  Stages stages(waves, scene);
  DoAll(AllNow(waves), stages);
  const std::vector<SceneWork> works = AllNow(waves);
  EXPECT_THAT(NamesOf(works), ElementsAre(StartsWith("cluster "), "assemble +003_+000", StartsWith("cluster ")));
  // A cell whose filling broke is written with the rest.
  DoAll(works, stages);
  const std::vector<SceneWork> fills = AllNow(waves);
  ASSERT_THAT(NamesOf(fills), AllOf(SizeIs(3), Each(StartsWith("fill "))));
  EXPECT_TRUE(waves.Take(LeftWork{LeftWork::Kind::kHoles, {0, 0}, "it broke"}).ok());
  stages.Do(fills[1]);
  stages.Do(fills[2]);
  const std::vector<SceneWork> rest = AllNow(waves);
  EXPECT_THAT(NamesOf(rest), ElementsAre("assemble +001_+000", "assemble +002_+000", "assemble +000_+000"));
  DoAll(rest, stages);
  EXPECT_THAT(AllNow(waves), IsEmpty());
  EXPECT_TRUE(waves.done());
}

}  // namespace
}  // namespace tilemend
