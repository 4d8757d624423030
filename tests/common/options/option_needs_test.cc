#include "common/options/option_needs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using testing::HasSubstr;

v1::JobSpec With(const char* surface, const char* filler) {
  v1::JobSpec spec;
  spec.set_surface(surface);
  spec.set_filler(filler);
  return spec;
}

bool IsMet(OptionNeeds needs, const v1::JobSpec& spec) { return WhyWithoutEffect(needs, spec).empty(); }

TEST(OptionNeedsTest, EachSurfaceHasOptionsOfItsOwn) {
  const v1::JobSpec plate = With("thin-plate", "auto"), wang = With("wang", "auto");
  EXPECT_TRUE(IsMet(OptionNeeds::kThinPlate, plate) && !IsMet(OptionNeeds::kThinPlate, wang));
  EXPECT_TRUE(IsMet(OptionNeeds::kWang, wang) && !IsMet(OptionNeeds::kWang, plate));
  EXPECT_TRUE(IsMet(OptionNeeds::kWangOrMinimumArea, wang) && !IsMet(OptionNeeds::kWangOrMinimumArea, plate));
  EXPECT_TRUE(IsMet(OptionNeeds::kWangOrMinimumArea, With("thin-plate", "minimum-area")));
  EXPECT_THAT(WhyWithoutEffect(OptionNeeds::kWang, plate), HasSubstr("leave it out, or choose that surface"));
}

TEST(OptionNeedsTest, EachFillerHasOptionsOfItsOwn) {
  const v1::JobSpec svm = With("thin-plate", "svm-laplacian"), none = With("thin-plate", "minimum-area");
  EXPECT_TRUE(IsMet(OptionNeeds::kFront, svm) && IsMet(OptionNeeds::kSvm, svm));
  EXPECT_FALSE(IsMet(OptionNeeds::kFrontNormal, svm) || IsMet(OptionNeeds::kFrontCurvature, svm));
  EXPECT_FALSE(IsMet(OptionNeeds::kFront, none));
  EXPECT_TRUE(IsMet(OptionNeeds::kFrontNormal, With("thin-plate", "advancing-front-normal")));
  EXPECT_TRUE(IsMet(OptionNeeds::kFrontCurvature, With("thin-plate", "advancing-front-curvature")));
  EXPECT_THAT(WhyWithoutEffect(OptionNeeds::kSvm, none), HasSubstr("or choose svm-laplacian"));
}

TEST(OptionNeedsTest, GrowthAndWaterCanBeOff) {
  v1::JobSpec spec;
  EXPECT_TRUE(IsMet(OptionNeeds::kNothing, spec) && IsMet(OptionNeeds::kGrowth, spec) &&
              IsMet(OptionNeeds::kWater, spec));
  spec.set_uniform(true);
  spec.set_water("off");
  EXPECT_FALSE(IsMet(OptionNeeds::kGrowth, spec) || IsMet(OptionNeeds::kWater, spec));
}

}  // namespace
}  // namespace tilemend
