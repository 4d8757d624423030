// What the properties of a polygon say (feature_properties.h), through the process that the programs start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

const std::string kSquare = PolygonText(SquareAt(0, 0, 4));  // NOLINT(cert-err58-cpp)

absl::StatusOr<WaterArea> AreaWith(const std::string& properties) {
  const auto file = ParseWaterFile({FeatureText(kSquare, properties)}, "f", {});
  if (!file.ok()) return file.status();
  return file->areas.at(0);
}

TEST(FeaturePropertiesTest, ACentrelineIsALineItsCoordinatesOrWkt) {
  for (const char* line : {R"({"type": "LineString", "coordinates": [[1, 1], [3, 2.5, 7]]})", "[[1, 1], [3, 2.5]]",
                           "\"LINESTRING (1 1, 3 2.5)\"", "\"MULTILINESTRING ((1 1, 3 2.5))\""}) {
    const auto file = ParseWaterFile({FeatureText(kSquare, absl::StrCat(R"({"centreline": )", line, "}"))}, "f", {});
    ASSERT_TRUE(file.ok()) << file.status();
    EXPECT_THAT(file->areas[0].centreline, ElementsAre(Point2(1, 1), Point2(3, 2.5))) << line;
  }
}

// dBase has ten letters for a name.
TEST(FeaturePropertiesTest, TheClearHeightOfAShapefileHasAShortName) {
  EXPECT_EQ(AreaWith(R"({"clear": true, "clear_heig": 0.5})")->clear_height, 0.5);
  EXPECT_EQ(AreaWith(R"({"clear": true, "clear_heig": 0.5, "clear_height": 0.75})")->clear_height, 0.75);
}

TEST(FeaturePropertiesTest, LongNamesAreCut) {
  const std::string name(1000000, 'n');
  const auto file = ParseWaterFile({FeatureText(kSquare, absl::StrCat(R"({"name": "\u001b)", name, "\"}"))}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas[0].label, StartsWith("feature 0 (\\x1bnnn"));
  EXPECT_LT(file->areas[0].label.size(), 120U);
  const absl::Status status = ParseWaterFile({CollectionText({FeatureText(kSquare)}, name)}, "f", {}).status();
  EXPECT_THAT(std::string(status.message()), HasSubstr("a CRS that is not known: 'nnn"));
  EXPECT_LT(status.message().size(), 300U);
}

TEST(FeaturePropertiesTest, ALevelIsANumberOrPlainText) {
  for (const char* text :
       {"3.25", "\"3.25\"", "\"3.25 m\"", "\" +3.25m \"", "\"03.250\"", "\"\u00a03.25\u202fm\u2009\""}) {
    const auto area = AreaWith(absl::StrCat(R"({"level_m": )", text, "}"));
    ASSERT_TRUE(area.ok()) << area.status();
    EXPECT_EQ(area->level, 3.25) << text;
  }
  EXPECT_EQ(AreaWith(R"({"level_m": "-0.5"})")->level, -0.5);
  for (const char* none : {"null", "\"\"", "\"  \""}) {
    EXPECT_EQ(AreaWith(absl::StrCat(R"({"level_m": )", none, "}"))->level, std::nullopt) << none;
  }
  for (const char* text : {"\"high\"", "\"3,25\"", "\"3.25 ft\"", "\"1e2\"", "\"nan\"", "\"inf\"", "\"m\"", "\"3 4\"",
                           "\"0x10\"", "\"1000000\"", "\"--1\"", "true", "1e6", "[3]", "{}"}) {
    const absl::Status status = AreaWith(absl::StrCat(R"({"name": "Pond", "level_m": )", text, "}")).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << text << status;
    EXPECT_THAT(std::string(status.message()), StartsWith("f: feature 0 (Pond): property level_m: '")) << text;
    EXPECT_THAT(std::string(status.message()),
                HasSubstr("expected a height in metres from -100000 to 100000, such as 3.25"))
        << text;
  }
}

TEST(FeaturePropertiesTest, AKindIsLakeOrRiver) {
  EXPECT_EQ(AreaWith("{}")->kind, WaterKind::kUnsaid);
  EXPECT_EQ(AreaWith(R"({"kind": ""})")->kind, WaterKind::kUnsaid);
  EXPECT_EQ(AreaWith(R"({"kind": "lake"})")->kind, WaterKind::kLake);
  EXPECT_EQ(AreaWith(R"({"Kind": " River "})")->kind, WaterKind::kRiver);
  for (const char* kind : {"\"pond\"", "\"lakes\"", "7", "true"}) {
    const absl::Status status = AreaWith(absl::StrCat(R"({"kind": )", kind, "}")).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    EXPECT_THAT(std::string(status.message()), StartsWith("f: feature 0: property kind: '")) << kind;
    EXPECT_THAT(std::string(status.message()), HasSubstr("expected lake or river")) << kind;
  }
}

TEST(FeaturePropertiesTest, SurfaceIsTakenOutWhereAPolygonSaysSo) {
  const auto none = AreaWith("{}"), some = AreaWith(R"({"clear": "yes", "clear_height": "2 m"})");
  ASSERT_TRUE(none.ok() && some.ok()) << none.status() << some.status();
  EXPECT_FALSE(none->clear);
  EXPECT_EQ(none->clear_height, kClearHeight);
  EXPECT_TRUE(some->clear);
  EXPECT_EQ(some->clear_height, 2);
  for (const char* bad : {R"({"clear": 3})", R"({"clear": true, "clear_height": -1})", R"({"clear_height": "high"})"})
    EXPECT_TRUE(absl::IsInvalidArgument(AreaWith(bad).status())) << bad;
}

TEST(FeaturePropertiesTest, WaterIsABooleanOrAWordForOne) {
  for (const char* yes : {"true", "1", "\"true\"", "\"T\"", "\"Yes\"", "\"y\"", "\"1\"", "null", "\"\""}) {
    const auto area = AreaWith(absl::StrCat(R"({"water": )", yes, "}"));
    ASSERT_TRUE(area.ok()) << area.status();
    EXPECT_TRUE(area->water) << yes;
  }
  for (const char* no : {"false", "0", "\"FALSE\"", "\"f\"", "\"no\"", "\"N\"", "\"0\""}) {
    const auto area = AreaWith(absl::StrCat(R"({"water": )", no, "}"));
    ASSERT_TRUE(area.ok()) << area.status();
    EXPECT_FALSE(area->water) << no;
  }
  for (const char* other : {"\"lake\"", "2", "0.5", "[1]"}) {
    const absl::Status status = AreaWith(absl::StrCat(R"({"water": )", other, "}")).status();
    EXPECT_THAT(std::string(status.message()), StartsWith("f: feature 0: property water: '")) << other;
    EXPECT_THAT(std::string(status.message()), HasSubstr("expected true or false")) << other;
  }
}

}  // namespace
}  // namespace tilemend
