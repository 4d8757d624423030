#include "coordinator/report/changed_options.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

TEST(ChangedOptionsTest, AreThoseThatDifferFromTheDefaults) {
  const Json report = {{"options", {{"textures", "off"}, {"gradation", 1.3}, {"uniform", true}}}};
  EXPECT_EQ(ChangedOptions(report), Json({{"textures", "off"}, {"uniform", true}}));
}

TEST(ChangedOptionsTest, OfAReportWithoutOptionsAreNone) {
  for (const Json& report : {Json::object(), Json{{"options", 3}}, Json()})
    EXPECT_EQ(ChangedOptions(report), Json::object());
}

}  // namespace
}  // namespace tilemend
