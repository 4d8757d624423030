#include "common/options/option.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using testing::HasSubstr;

const Option kNumber = {.field = "size_limit",
                        .type = OptionType::kNumber,
                        .words = {"auto"},
                        .value_name = "X",
                        .min = 1,
                        .max = 1e6,
                        .default_value = "auto",
                        .unit = "m",
                        .help = "how large"};
const Option kWord = {.field = "textures", .type = OptionType::kWord, .words = {"copy", "link", "off"}};

TEST(OptionTest, SaysWhatIsAllowed) {
  EXPECT_EQ(Expected(kNumber), "auto or a number from 1 to 1e6");
  EXPECT_EQ(Expected(kWord), "copy, link or off");
  EXPECT_EQ(Expected({.field = "longest_loop", .type = OptionType::kWholeNumber, .min = 3, .max = 2000}),
            "a whole number from 3 to 2000");
  EXPECT_EQ(Expected({.field = "water", .type = OptionType::kPath, .words = {"auto", "off"}}),
            "auto, off or a path in UTF-8");
}

TEST(OptionTest, ShowsWhatAValueMayBe) {
  EXPECT_EQ(FlagOf(kNumber), "size-limit");
  EXPECT_EQ(ValueShown(kNumber), "auto|X");
  EXPECT_EQ(ValueShown(kWord), "copy|link|off");
  EXPECT_EQ(ValueShown({.field = "uniform"}), "");
  EXPECT_EQ(OptionFlag("filler", kOfJobs).value, "NAME");
}

TEST(OptionTest, FlagsSayRangeAndWords) {
  EXPECT_THAT(OptionFlag("tension", kOfFill).help, HasSubstr("0 to 1000 per m^2"));
  EXPECT_THAT(OptionFlag("filler", kOfJobs).help, HasSubstr("svm-laplacian or minimum-area"));
  EXPECT_EQ(OptionFlag("surface", kOfJobs).group, FlagGroup::kPapers);
  EXPECT_EQ(OptionFlag("gradation", kOfJobs).default_value, "1.3");
  EXPECT_EQ(OptionFlag("out", kOfFill).value, "FILE");
  EXPECT_EQ(OptionFlag("out", kOfJobs).value, "DIR");
}

}  // namespace
}  // namespace tilemend
