#include "coordinator/jobs/scene_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "common/options/job_options.h"

namespace tilemend {
namespace {

TEST(SceneOptionsTest, WavesAskWhetherTheJobIsCancelled) {
  bool cancelled = false;
  JobSpec spec = WithDefaults({});
  spec.set_surface("wang");
  spec.set_dry_run(true);
  spec.set_water_colour("#010203");
  const WaveOptions options = WaveOptionsOf(spec, {}, [&] { return cancelled; });
  EXPECT_EQ(options.surface, Surface::kWang);
  EXPECT_EQ(options.plan.seam_points, SeamPoints::kProjected);
  EXPECT_EQ(WaveOptionsOf(WithDefaults({}), {}, {}).plan.seam_points, SeamPoints::kSpaced);
  EXPECT_TRUE(options.plan_only);
  EXPECT_EQ(options.plan.water_colour, (Rgb{1, 2, 3}));
  EXPECT_FALSE(options.plan.cancelled());
  cancelled = true;
  EXPECT_TRUE(options.plan.cancelled());
}

TEST(JobKeyTest, DecisionsCountForTheJobButNotForItsScene) {
  JobSpec spec = WithDefaults({});
  WaterChoice water;
  const std::string scene = SceneKey(spec, water, ""), job = JobKey(spec, water, "");
  EXPECT_EQ(job, scene);
  spec.set_decisions("/marks.geojson");
  water.decisions_digest = "ab";
  EXPECT_EQ(SceneKey(spec, water, ""), scene);
  EXPECT_NE(JobKey(spec, water, ""), job);
}

TEST(JobKeyTest, TellsApartWhatGivesOtherBytes) {
  std::set<std::string> keys;
  const auto add = [&](auto change) {
    JobSpec spec = WithDefaults({});
    WaterChoice water;
    std::string area;
    change(spec, water, area);
    EXPECT_TRUE(keys.insert(JobKey(spec, water, area)).second);
  };
  add([](JobSpec&, WaterChoice&, std::string&) {});
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.set_gradation(std::nextafter(spec.gradation(), 2)); });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.set_tension(0); });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.set_surface("wang"); });
  add([](JobSpec& spec, WaterChoice&, std::string&) {
    spec.set_surface("wang");
    spec.set_closure("line");
  });
  add([](JobSpec& spec, WaterChoice&, std::string&) { spec.set_cells("1,1"); });
  add([](JobSpec&, WaterChoice& water, std::string&) { water.digest = "other content"; });
  add([](JobSpec&, WaterChoice&, std::string& area) { area = "other content"; });
}

TEST(JobKeyTest, ForgetsWhereToAndWhetherToOverwrite) {
  JobSpec a = WithDefaults({}), b = a;
  a.set_out("/a");
  b.set_overwrite(true);
  EXPECT_EQ(JobKey(a, {}, ""), JobKey(b, {}, ""));
}

}  // namespace
}  // namespace tilemend
