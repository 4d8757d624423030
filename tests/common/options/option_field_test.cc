#include "common/options/option_field.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

const Option kGrowth = {.field = "gradation", .type = OptionType::kNumber, .default_value = "1.3"};
const Option kTension = {.field = "tension", .type = OptionType::kNumber, .default_value = "auto"};
const Option kHole = {.field = "largest_hole", .type = OptionType::kWholeNumber};
const Option kLoop = {.field = "longest_loop", .type = OptionType::kWholeNumber, .default_value = "400"};
const Option kSurface = {.field = "surface", .type = OptionType::kWord, .default_value = "thin-plate"};
const Option kUniform = {.field = "uniform"};

TEST(OptionFieldTest, OnlyFieldsWithoutOptionalTakeDefaults) {
  v1::JobSpec spec;
  for (const Option* option : {&kGrowth, &kTension, &kLoop, &kSurface, &kUniform}) {
    OptionField(*option).SetDefault(spec);
    EXPECT_FALSE(OptionField(*option).Differs(spec)) << option->field;
  }
  EXPECT_EQ(spec.gradation(), 1.3);
  EXPECT_EQ(spec.surface(), "thin-plate");
  EXPECT_FALSE(spec.has_tension() || spec.has_longest_loop());
  spec.set_gradation(2);
  OptionField(kGrowth).SetDefault(spec);
  EXPECT_EQ(spec.gradation(), 2);
}

TEST(OptionFieldTest, SetsEveryTypeAndTellsIt) {
  v1::JobSpec spec;
  OptionField(kTension).SetNumber(0, spec);
  OptionField(kLoop).SetNumber(7, spec);
  OptionField(kHole).SetNumber(1e9, spec);
  OptionField(kSurface).SetText("wang", spec);
  OptionField(kUniform).SetSwitch(true, spec);
  EXPECT_TRUE(spec.has_tension());
  EXPECT_EQ(spec.longest_loop(), 7);
  EXPECT_EQ(spec.largest_hole(), 1'000'000'000);
  EXPECT_EQ(OptionField(kHole).Number(spec), 1e9);
  EXPECT_EQ(OptionField(kLoop).Number(spec), 7);
  EXPECT_EQ(OptionField(kSurface).Text(spec), "wang");
  v1::JobSpec copy;
  for (const Option* option : {&kTension, &kLoop, &kHole, &kSurface, &kUniform}) {
    EXPECT_TRUE(OptionField(*option).Differs(spec)) << option->field;
    OptionField(*option).Copy(spec, copy);
  }
  EXPECT_EQ(copy.SerializeAsString(), spec.SerializeAsString());
}

TEST(OptionFieldTest, ReportsTheDefaultOfWhatIsAbsent) {
  using Value = decltype(ReportedOption::value);
  v1::JobSpec spec;
  EXPECT_EQ(OptionField(kTension).Value(spec), Value(std::string("auto")));
  EXPECT_EQ(OptionField(kLoop).Value(spec), Value(400.0));
  EXPECT_EQ(OptionField(kUniform).Value(spec), Value(false));
  spec.set_tension(0.5);
  spec.set_surface("wang");
  EXPECT_EQ(OptionField(kTension).Value(spec), Value(0.5));
  EXPECT_EQ(OptionField(kSurface).Value(spec), Value(std::string("wang")));
}

}  // namespace
}  // namespace tilemend
