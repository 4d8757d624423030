#include "coordinator/service/scene_options.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tilemend {
namespace {

TEST(SceneOptionsTest, WavesAskWhetherTheJobIsCancelled) {
  bool cancelled = false;
  JobSpec spec;
  spec.surface = "wang";
  spec.dry_run = true;
  spec.water_colour = "#010203";
  const WaveOptions options = WaveOptionsOf(spec, {}, [&] { return cancelled; });
  EXPECT_EQ(options.surface, Surface::kWang);
  EXPECT_TRUE(options.plan_only);
  EXPECT_EQ(options.plan.water_colour, (Rgb{1, 2, 3}));
  EXPECT_FALSE(options.plan.cancelled());
  cancelled = true;
  EXPECT_TRUE(options.plan.cancelled());
}

TEST(SceneOptionsTest, ATensionIsSentOnlyWhereOneIsGiven) {
  JobSpec spec;
  EXPECT_FALSE(ShapeOptionsOf(spec).has_tension());
  EXPECT_TRUE(ShapeOptionsOf(spec).thin_plate());
  spec.tension = 0.5;
  EXPECT_EQ(ShapeOptionsOf(spec).tension(), 0.5);
}

TEST(SceneOptionsTest, TheReportNamesOptionsAsTheFlagsDo) {
  const auto options = OptionsOf(JobSpec());
  const auto has = [&](const char* name) {
    return std::any_of(options.begin(), options.end(), [&](const ReportedOption& o) { return o.name == name; });
  };
  EXPECT_TRUE(has("size-limit"));
  EXPECT_TRUE(has("water-profile"));
}

}  // namespace
}  // namespace tilemend
