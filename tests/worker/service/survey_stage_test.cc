#include "worker/service/survey_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "common/codec/mesh_file.h"
#include "common/mesh/height_tally.h"
#include "common/mesh/mesh_limits.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/ground_payloads.h"
#include "common/store/digest.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSide = 12;  // metres

// A square tile of two levels: 1 m in its west, 2 m in its east.
class SurveyStageTest : public testing::Test {
 protected:
  SurveyStageTest() {
    const TriMesh mesh = SquaresMesh(
        0, kSide, 0, kSide, [](int32_t, int32_t) { return true; },
        [](double x, double) { return x < kSide / 2.0 ? 1.0 : 2.0; });
    const std::vector<int32_t> like(mesh.points.size(), -1);
    const std::string bytes = NewPlyFile({mesh.points, like, mesh.triangles}, NumberType::kFloat64);
    folder_.Write("a.ply", bytes);
    tile_.set_root(folder_.path());
    tile_.set_path("a.ply");
    digest_ = FileDigest(bytes);
  }

  static ClearArea Rectangle(double x0, double x1, double top) {
    return {{{{{x0, 2}, {x1, 2}, {x1, 10}, {x0, 10}}}}, top};
  }

  v1::SurveyOutput Survey(const v1::TileRef& tile, bool look) {
    v1::SurveyInput input;
    *input.mutable_tile() = tile;
    input.set_look(look);
    input.set_raster_square(1);
    const auto bytes = RunSurvey(input, memory_);
    EXPECT_TRUE(bytes.ok()) << bytes.status();
    v1::SurveyOutput output;
    EXPECT_TRUE(bytes.ok() && output.ParseFromString(*bytes));
    return output;
  }

  // The lowest surface in the square around a place.
  static float LowestAt(const v1::SurveyOutput& output, double x, double y) {
    const auto raster = FromProto(output.lowest());
    EXPECT_TRUE(raster.ok()) << raster.status();
    return raster->heights[raster->IndexOf(SquareAt(x, 1), SquareAt(y, 1))];
  }

  TemporaryFolder folder_;
  TaskMemory memory_{int64_t{1} << 30};
  v1::TileRef tile_;
  std::string digest_;
};

// Whose every vertex is on a boundary.
TEST_F(SurveyStageTest, ATileWithALongerBoundaryThanAnyResultMayHaveFailsWithAReason) {
  TriMesh mesh;
  for (int32_t v = 0; v <= kMaxResultPoints; v += 3) {
    const Point3 corner(v % 3000, v / 3000, 0);
    mesh.points.insert(mesh.points.end(), {corner, corner + Point3(1, 0, 0), corner + Point3(0, 0.5, 0)});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  const std::vector<int32_t> like(mesh.points.size(), -1);
  folder_.Write("a.ply", NewPlyFile({mesh.points, like, mesh.triangles}, NumberType::kFloat64));
  v1::SurveyInput input;
  *input.mutable_tile() = tile_;
  for (const bool look : {false, true}) {
    input.set_look(look);
    const absl::Status status = RunSurvey(input, memory_).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()),
                HasSubstr("a.ply: the surface along its boundaries has 4000002 vertices"));
  }
}

TEST_F(SurveyStageTest, MeasuresHowMuchSurfaceLiesAtWhichHeight) {
  v1::MeasureInput input;
  *input.mutable_tile() = tile_;
  *input.add_areas() = ToProto(Rectangle(1, 4, 0));
  *input.add_areas() = ToProto(Rectangle(8, 10, 0));
  const auto bytes = RunMeasure(input, memory_);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  v1::MeasureOutput output;
  ASSERT_TRUE(output.ParseFromString(*bytes));
  EXPECT_EQ(output.digest(), digest_);
  ASSERT_EQ(output.tallies_size(), 2);
  for (const int i : {0, 1}) {
    const auto tally = FromProto(output.tallies(i));
    ASSERT_TRUE(tally.ok()) << tally.status();
    const auto level = HalfSampleMode(*tally);
    ASSERT_TRUE(level.has_value());
    EXPECT_NEAR(*level, i + 1, 0.01);
  }
}

TEST_F(SurveyStageTest, TheGroundRasterOfAClearedTileHasNoSurfaceWhereItIsTakenOut) {
  v1::TileRef cleared = tile_;
  *cleared.add_clear() = ToProto(Rectangle(2, 10, kInfinity));
  for (const bool look : {false, true}) {
    EXPECT_EQ(LowestAt(Survey(tile_, look), 3.5, 5.5), 1);
    const v1::SurveyOutput output = Survey(cleared, look);
    EXPECT_TRUE(std::isnan(LowestAt(output, 3.5, 5.5)));
    EXPECT_EQ(LowestAt(output, 0.5, 0.5), 1);
    EXPECT_EQ(output.digest(), digest_) << "that of the file";
    ASSERT_EQ(output.cleared_size(), 1);
    EXPECT_EQ(output.triangle_count(), 2 * kSide * kSide - output.cleared(0));
  }
}

TEST_F(SurveyStageTest, WhatStandsAboveTheTopIsStillThere) {
  v1::TileRef cleared = tile_;
  *cleared.add_clear() = ToProto(Rectangle(2, 10, 1.5));
  const v1::SurveyOutput output = Survey(cleared, false);
  EXPECT_TRUE(std::isnan(LowestAt(output, 3.5, 5.5)));
  EXPECT_EQ(LowestAt(output, 8.5, 5.5), 2);
}

TEST_F(SurveyStageTest, ASurveyThatHoldsIsNotMadeAgain) {
  const v1::SurveyOutput first = Survey(tile_, false);
  v1::SurveyInput input;
  *input.mutable_tile() = tile_;
  *input.mutable_known() = first.witness();
  const auto bytes = RunSurvey(input, memory_);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  v1::SurveyOutput output;
  ASSERT_TRUE(output.ParseFromString(*bytes));
  EXPECT_TRUE(output.unchanged());
}

TEST_F(SurveyStageTest, NamesTheTileThatCannotBeRead) {
  v1::MeasureInput input;
  input.mutable_tile()->set_root(folder_.path());
  input.mutable_tile()->set_path("none.ply");
  EXPECT_THAT(std::string(RunMeasure(input, memory_).status().message()), HasSubstr("none.ply"));
}

}  // namespace
}  // namespace tilemend
