#include "coordinator/waves/scene_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class SceneSurveyTest : public testing::Test {
 protected:
  // Two cells; that in the middle has no tile.
  SceneSurveyTest() : scene_(PictureScene({"####....####", "####....####", "####....####", "####....####"}, 4)) {}

  void TakeAll() {
    for (const auto& [cell, record] : scene_.records) EXPECT_TRUE(survey_.Take(SurveyInMemory(cell, record)).ok());
  }

  const SurveyedScene scene_;
  SceneSurvey survey_{scene_.AsScene(), {}};
};

TEST_F(SceneSurveyTest, SurveysCellsWithATile) {
  EXPECT_THAT(survey_.ToMeasure(), IsEmpty());
  EXPECT_THAT(survey_.ToSurvey(), ElementsAre(CellId{0, 0}, CellId{2, 0}));
}

TEST_F(SceneSurveyTest, MeasuresTilesInReachOfWaterWithoutALevel) {
  WaterArea area;
  area.clear = true;
  area.polygon.rings = {{{9, 1}, {11, 1}, {11, 3}, {9, 3}}};
  SceneSurvey survey(scene_.AsScene(), {area});
  EXPECT_THAT(survey.ToMeasure(), ElementsAre(CellId{2, 0}));
  EXPECT_TRUE(absl::IsInvalidArgument(survey.Take(TileLevels{{2, 0}, {}})));
}

TEST_F(SceneSurveyTest, RefusesCountsOfAreasThatTakeNothing) {
  EXPECT_TRUE(absl::IsInvalidArgument(survey_.Take(SurveyInMemory({0, 0}, scene_.records.at({0, 0}), {3}))));
  EXPECT_THAT(survey_.records(), IsEmpty());
}

TEST_F(SceneSurveyTest, TakesAsManyGroundValuesAsBoundaryVertices) {
  TakeAll();
  const size_t vertices = scene_.records.at({0, 0}).vertices.size();
  const auto take = [&](CellId cell, size_t count) {
    return survey_.Take(CellGround{cell, {std::vector<bool>(count), std::vector<float>(count)}});
  };
  EXPECT_EQ(take({0, 0}, vertices - 1).message(), "not a value for each boundary vertex");
  EXPECT_EQ(take({1, 0}, vertices).message(), "cell +001_+000 has no tile");
  EXPECT_THAT(survey_.input().rim_ground, IsEmpty());
  EXPECT_TRUE(take({0, 0}, vertices).ok());
  EXPECT_THAT(survey_.input().rim_ground, SizeIs(1));
}

TEST_F(SceneSurveyTest, IsCompleteWithANullRecordForACellWithoutATile) {
  TakeAll();
  survey_.Complete({});
  EXPECT_THAT(survey_.records(), SizeIs(3));
  EXPECT_TRUE(survey_.records().at({1, 0}) == nullptr);
  EXPECT_TRUE(survey_.input().has_grid);
  EXPECT_TRUE(survey_.input().area_known);
}

TEST_F(SceneSurveyTest, ASingleMeshGetsACellAroundIt) {
  TakeAll();
  WaveOptions options;
  options.single_mesh = true;
  EXPECT_THAT(survey_.ToTellGround(options), IsEmpty());
  survey_.Complete(options);
  EXPECT_EQ(survey_.input().grid.cell_size, Point2(12, 12));
  EXPECT_EQ(survey_.input().grid.corner, Point2(-4, -4));
}

}  // namespace
}  // namespace tilemend
