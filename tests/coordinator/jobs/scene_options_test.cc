#include "coordinator/jobs/scene_options.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tilemend
