#include "common/gis/property_names.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

TEST(PropertyMeantByTest, KnowsOtherSpellingsAndWords) {
  for (const char* name : {"water", "WATER", "watr", "waters", "wader", "wa_ter"}) {
    EXPECT_EQ(PropertyMeantBy(name), kWaterProperty) << name;
  }
  for (const char* name : {"level", "Level_M", "levelm", "level-m", "levelm2", "z", "Z", "height", "elevation"}) {
    EXPECT_EQ(PropertyMeantBy(name), kLevelProperty) << name;
  }
  for (const char* name : {"centerline", "centre_line", "Center Line", "centrelin", "centrline", "cetnreline"}) {
    EXPECT_EQ(PropertyMeantBy(name), kCentrelineProperty) << name;
  }
  for (const char* name : {"decision", "Decisions", "descision"}) {
    EXPECT_EQ(PropertyMeantBy(name), kDecisionProperty) << name;
  }
  for (const char* name : {"Clear", "cleared", "clears"}) EXPECT_EQ(PropertyMeantBy(name), kClearProperty) << name;
}

TEST(PropertyMeantByTest, OtherPropertiesAreNearNone) {
  const std::string names[] = {"",         "name",      "layer",     "LAYER",  "waterway",
                               "fid",      "natural",   "surface",   "kind",   "body",
                               "area_m2",  "length",    "depth",     "x",      "source",
                               "lowest_m", "highest_m", "levels_of", "center", std::string(1000000, 'w')};
  for (const std::string& name : names) {
    EXPECT_EQ(PropertyMeantBy(name), "") << name;
  }
}

}  // namespace
}  // namespace tilemend
