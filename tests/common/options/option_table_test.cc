// Holds the table of options to the message v1::JobSpec.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "absl/strings/numbers.h"
#include "common/options/job_options.h"
#include "common/options/option.h"

namespace tilemend {
namespace {

using google::protobuf::FieldDescriptor;

TEST(OptionTableTest, EveryFieldButTheSceneIsAnOption) {
  std::set<std::string> fields, options;
  for (int i = 0; i < v1::JobSpec::descriptor()->field_count(); ++i) {
    fields.insert(v1::JobSpec::descriptor()->field(i)->name());
  }
  for (const Option& option : AllOptions()) options.insert(option.field);
  options.insert("scene");
  EXPECT_EQ(options, fields);
}

TEST(OptionTableTest, NoCommandHasAnOptionTwice) {
  for (const unsigned command : {kOfJobs, kOfFill, kOfInspect}) {
    std::set<std::string> names;
    for (const FlagSpec& flag : OptionFlags(command)) EXPECT_TRUE(names.insert(flag.name).second) << flag.name;
  }
}

TEST(OptionTableTest, FieldsHaveTheTypesOfTheirOptions) {
  for (const Option& option : AllOptions()) {
    const FieldDescriptor& field = *v1::JobSpec::descriptor()->FindFieldByName(option.field);
    const auto type = field.cpp_type();
    switch (option.type) {
      case OptionType::kSwitch:
        EXPECT_EQ(type, FieldDescriptor::CPPTYPE_BOOL) << option.field;
        break;
      case OptionType::kNumber:
        EXPECT_EQ(type, FieldDescriptor::CPPTYPE_DOUBLE) << option.field;
        break;
      case OptionType::kWholeNumber:
        EXPECT_TRUE(type == FieldDescriptor::CPPTYPE_INT32 || type == FieldDescriptor::CPPTYPE_INT64) << option.field;
        break;
      default:
        EXPECT_EQ(type, FieldDescriptor::CPPTYPE_STRING) << option.field;
    }
  }
}

// A number without `optional` must have a default, and 0 must be none of its values: it means that none is given.
TEST(OptionTableTest, NumbersHaveRangesAndDefaultsWithin) {
  for (const Option& option : AllOptions()) {
    if (option.type != OptionType::kNumber && option.type != OptionType::kWholeNumber) continue;
    EXPECT_LT(option.min, option.max) << option.field;
    double value = 0;
    const bool is_number = absl::SimpleAtod(option.default_value, &value);
    if (is_number) {
      EXPECT_TRUE(value >= option.min && value <= option.max) << option.field;
    } else {
      EXPECT_EQ(option.words, std::vector<std::string>{option.default_value}) << option.field;
    }
    if (v1::JobSpec::descriptor()->FindFieldByName(option.field)->has_presence()) continue;
    EXPECT_TRUE(is_number && option.min > 0) << option.field;
  }
}

TEST(OptionTableTest, EveryOptionOfWorkersIsInTheReport) {
  for (const Option& option : AllOptions()) EXPECT_TRUE(option.in_report || !option.to_workers) << option.field;
}

TEST(OptionTableTest, TheDefaultsAreSound) {
  v1::JobSpec spec = WithDefaults({});
  spec.set_scene("/scene");
  spec.set_out("/out");
  EXPECT_TRUE(CheckJob(spec).ok()) << CheckJob(spec);
}

}  // namespace
}  // namespace tilemend
