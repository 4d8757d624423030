#include "worker/service/fill_options.h"

#include <gtest/gtest.h>

#include "common/options/job_options.h"

namespace tilemend {
namespace {

TEST(FillOptionsTest, TakesWhatTheSpecSays) {
  v1::JobSpec spec = WithDefaults({});
  spec.set_surface("wang");
  spec.set_filler("minimum-area");
  spec.set_gradation(2);
  spec.set_size_limit(9);
  spec.set_uniform(true);
  spec.set_tension(0.5);
  spec.set_longest_loop(7);
  spec.set_svm_rings(4);
  spec.set_allow_creases(true);
  const FillOptions options = FillOptionsOf(spec);
  EXPECT_EQ(options.surface, Surface::kWang);
  EXPECT_EQ(options.filler, Filler::kMinimumArea);
  EXPECT_EQ(options.refine.gradation, 2);
  EXPECT_EQ(options.refine.size_limit, 9);
  EXPECT_TRUE(options.refine.uniform && options.allow_creases);
  EXPECT_EQ(options.tension, 0.5);
  EXPECT_EQ(options.wang.longest_loop, 7);
  EXPECT_EQ(options.filling.rings, 4);
  EXPECT_NE(options.published, nullptr);
}

TEST(FillOptionsTest, DefaultsAreThoseOfTheGeometry) {
  const FillOptions options = FillOptionsOf(WithDefaults({}));
  EXPECT_EQ(options.surface, kDefaultSurface);
  EXPECT_EQ(options.filler, Filler::kAuto);
  EXPECT_EQ(options.refine.gradation, RefineOptions().gradation);
  EXPECT_EQ(options.refine.size_limit, RefineOptions().size_limit);
  EXPECT_FALSE(options.tension.has_value());
}

}  // namespace
}  // namespace tilemend
