#include "coordinator/jobs/scene_options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

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
  EXPECT_EQ(options.plan.seam_points, SeamPoints::kProjected);
  EXPECT_EQ(WaveOptionsOf({}, {}, {}).plan.seam_points, SeamPoints::kSpaced);
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

TEST(JobKeyTest, TellsApartWhatGivesOtherBytes) {
  std::set<std::string> keys;
  const auto add = [&](auto change) {
    JobSpec spec;
    WaterChoice water;
    std::string area;
    change(spec, water, area);
    EXPECT_TRUE(keys.insert(JobKey(spec, water, area)).second);
  };
  add([](JobSpec&, WaterChoice&, std::string&) {});
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.gradation = std::nextafter(spec.gradation, 2); });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.tension = 0; });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.seam_points = "spaced"; });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.closure = "line"; });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.cells = "1,1"; });
  add([](JobSpec&, WaterChoice& water, std::string&) { water.digest = "other content"; });
  add([](JobSpec&, WaterChoice&, std::string& area) { area = "other content"; });
}

TEST(JobKeyTest, ForgetsWhereToAndWhetherToOverwrite) {
  JobSpec a, b;
  a.out = "/a";
  b.overwrite = true;
  EXPECT_EQ(JobKey(a, {}, ""), JobKey(b, {}, ""));
}

TEST(ShapeOptionsOfTest, ATensionThatIsChosenIsNotSaid) {
  JobSpec spec;
  EXPECT_FALSE(ShapeOptionsOf(spec).has_tension());
  spec.tension = 0;
  EXPECT_TRUE(ShapeOptionsOf(spec).has_tension());
}

}  // namespace
}  // namespace tilemend
