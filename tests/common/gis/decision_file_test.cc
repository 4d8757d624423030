// What a reviewer decided on holes (ParseDecisionFile), through the process that the programs start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

std::string DecisionAt(double x, const std::string& properties) {
  return FeatureText(PolygonText(SquareAt(x, 0, 4)), properties);
}

absl::StatusOr<WaterFile> Parse(const std::vector<std::string>& features) {
  return ParseDecisionFile({CollectionText(features)}, "d.geojson", {});
}

TEST(DecisionFileTest, EachDecisionIsAnArea) {
  const auto file = Parse({DecisionAt(0, R"({"hole": 7, "decision": "accept", "level_m": null})"),
                           DecisionAt(10, R"({"hole": 8, "decision": "Water", "level_m": 3.25})"),
                           DecisionAt(20, R"({"decision": "water"})"), DecisionAt(30, R"({"decision": "ground"})"),
                           DecisionAt(40, R"({"decision": "open"})")});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings, IsEmpty());
  ASSERT_THAT(file->areas, SizeIs(5));
  std::vector<ReviewDecision> decisions;
  for (const WaterArea& area : file->areas) {
    decisions.push_back(area.decision);
    EXPECT_EQ(area.water, area.decision == ReviewDecision::kWater);
    EXPECT_FALSE(area.clear);
  }
  EXPECT_THAT(decisions, ElementsAre(ReviewDecision::kAccept, ReviewDecision::kWater, ReviewDecision::kWater,
                                     ReviewDecision::kGround, ReviewDecision::kOpen));
  EXPECT_EQ(file->areas[0].label, "decision on hole 7");
  EXPECT_EQ(file->areas[1].level, 3.25);
  EXPECT_EQ(file->areas[2].level, std::nullopt);
  EXPECT_EQ(file->areas[2].label, "decision of feature 2");
}

TEST(DecisionFileTest, HolesWithoutADecisionAreLeftOut) {
  const auto file = Parse(
      {DecisionAt(0, R"({"hole": 1, "decision": null, "water": true})"), DecisionAt(10, R"({"decision": "open"})")});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_EQ(file->areas[0].polygon.rings[0][0].x(), 10);
}

// It would undo all that was decided before.
TEST(DecisionFileTest, AFileOfOtherFeaturesIsRefused) {
  for (const std::vector<std::string>& features :
       {std::vector{DecisionAt(0, "{}"), DecisionAt(9, R"({"hole": 1, "decision": null})")},
        std::vector{FeatureText(R"({"type":"Point","coordinates":[1,1]})", R"({"decision": "open"})")}}) {
    const auto other = Parse(features);
    EXPECT_TRUE(absl::IsInvalidArgument(other.status())) << other.status();
    EXPECT_THAT(std::string(other.status().message()),
                AllOf(StartsWith(absl::StrCat("d.geojson: none of its features (", features.size(), ") is a decision")),
                      HasSubstr("property \"decision\" (accept, water, ground or open)"),
                      HasSubstr("a file without features undoes all decisions")));
  }
}

TEST(DecisionFileTest, AFileWithoutFeaturesHoldsNoDecision) {
  const auto none = Parse({});
  ASSERT_TRUE(none.ok()) << none.status();
  EXPECT_THAT(none->areas, IsEmpty());
  EXPECT_THAT(none->warnings, ElementsAre("d.geojson: holds no decision"));
}

// As holes.geojson has them, with decisions that were typed in a GIS.
TEST(DecisionFileTest, HolesOfAClusterWithOneDecisionAreOneArea) {
  const auto file = Parse({DecisionAt(0, R"({"hole": 1, "cluster": 3, "decision": "water", "level_m": 2})"),
                           DecisionAt(4, R"({"hole": 2, "cluster": 3, "decision": "water", "level_m": 2})"),
                           DecisionAt(8, R"({"hole": 3, "cluster": 4, "decision": "water", "level_m": 2})"),
                           DecisionAt(12, R"({"hole": 4, "cluster": 4, "decision": "open"})")});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(3));
  EXPECT_TRUE(Contains(file->areas[0].polygon, {2, 2}));
  EXPECT_TRUE(Contains(file->areas[0].polygon, {6, 2}));
  EXPECT_FALSE(Contains(file->areas[0].polygon, {10, 2}));
  EXPECT_EQ(file->areas[0].label, "decision on holes 1, 2");
}

TEST(DecisionFileTest, ALabelNamesFiveHoles) {
  std::vector<std::string> features;
  for (int k = 0; k < 7; ++k)
    features.push_back(DecisionAt(4 * k, absl::StrCat(R"({"cluster": 1, "decision": "open", "hole": )", k, "}")));
  const auto file = Parse(features);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->areas[0].label, "decision on holes 0, 1, 2, 3, 4 and 2 more");
}

TEST(DecisionFileTest, ABadFileIsRefusedWithThePlace) {
  const auto message = [](const absl::StatusOr<WaterFile>& file) {
    EXPECT_TRUE(absl::IsInvalidArgument(file.status())) << file.status();
    return std::string(file.status().message());
  };
  EXPECT_THAT(message(Parse({DecisionAt(0, R"({"decision": "open"})"), DecisionAt(9, R"({"decision": "lake"})")})),
              AllOf(StartsWith("d.geojson: feature 1: property decision: 'lake'"),
                    HasSubstr("expected accept, water, ground or open")));
  EXPECT_THAT(message(Parse({DecisionAt(0, R"({"decision": "water", "level_m": "high"})")})),
              StartsWith("d.geojson: feature 0: property level_m: 'high'"));
  EXPECT_THAT(message(Parse({FeatureText(LineText({{0, 0}, {9, 9}}), R"({"decision": "open"})")})),
              StartsWith("d.geojson: feature 0: a decision on a line"));
  EXPECT_THAT(message(ParseDecisionFile({"{\"type\": \"FeatureCollection\",\n \"features\": [}"}, "d.geojson", {})),
              AllOf(StartsWith("d.geojson: "), HasSubstr("line 2")));
}

TEST(DecisionFileTest, ALevelThatHasNoEffectIsNamed) {
  const auto file = Parse({DecisionAt(0, R"({"decision": "ground", "level_m": 2})")});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->areas[0].level, std::nullopt);
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("feature 0: its level_m has no effect")));
  const auto misspelt = Parse({DecisionAt(0, R"({"decision": "water", "hight": 1, "level": 3})")});
  ASSERT_TRUE(misspelt.ok()) << misspelt.status();
  EXPECT_THAT(misspelt->warnings, ElementsAre(HasSubstr("property 'level' has no effect")));
}

}  // namespace
}  // namespace tilemend
