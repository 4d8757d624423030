// What ReadVectors makes of geometries and properties (raw_features.h), through the process that the programs start.
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
using ::testing::UnorderedElementsAre;

const std::string kSquare = PolygonText(SquareAt(0, 0, 4));  // NOLINT(cert-err58-cpp)

std::string PolygonOf(const std::string& ring) { return R"({"type": "Polygon", "coordinates": [)" + ring + "]}"; }

TEST(RawFeaturesTest, ABarePolygonIsWater) {
  const auto file = ParseWaterFile({kSquare}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(1));
  EXPECT_TRUE(file->areas[0].water);
  EXPECT_EQ(file->areas[0].level, std::nullopt);
  ASSERT_THAT(file->areas[0].polygon.rings, SizeIs(1));
  ASSERT_THAT(file->areas[0].polygon.rings[0], SizeIs(4)) << "the closing position is not repeated";
  EXPECT_EQ(file->areas[0].polygon.rings[0][2], Point2(4, 4));
}

TEST(RawFeaturesTest, FeaturesKeepTheirOrderAndSayWhatTheyAre) {
  const auto file =
      ParseWaterFile({CollectionText({FeatureText(kSquare, R"({"water": false})"), FeatureText(kSquare, "null"),
                                      FeatureText(kSquare, R"({"name": "Pond", "water": null, "level_m": null})"),
                                      FeatureText(kSquare, R"({"water": true, "level_m": -3, "depth": [1, 2]})")})},
                     "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(4));
  EXPECT_FALSE(file->areas[0].water);
  for (const int i : {1, 2, 3}) EXPECT_TRUE(file->areas[i].water) << i;
  EXPECT_EQ(file->areas[2].level, std::nullopt);
  EXPECT_EQ(file->areas[2].label, "feature 2 (Pond)");
  EXPECT_EQ(file->areas[3].level, -3);
}

TEST(RawFeaturesTest, PropertiesThatAreNearKnownOnesAreTold) {
  const std::string line = FeatureText(LineText({{1, 1}, {3, 3}}), R"({"elevation": 5})");
  const auto file = ParseWaterFile(
      {CollectionText(
          {FeatureText(kSquare, R"({"layer": "lakes", "Water": true})"), FeatureText(kSquare, R"({"watr": false})"),
           FeatureText(kSquare, R"({"name": "Pond", "level": 11.5})"), FeatureText(kSquare, R"({"level": 3})"),
           FeatureText(kSquare, R"({"level": 3, "level_m": 4})"), line})},
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->warnings,
              UnorderedElementsAre(
                  "f: feature 1: property 'watr' has no effect; the name that has is 'water'",
                  "f: feature 2 (Pond) and 1 more: property 'level' has no effect; the name that has is 'level_m'"));
}

struct BadCase {
  std::string text;
  std::string message;
};

TEST(RawFeaturesTest, ErrorsNameTheFileAndThePlace) {
  const BadCase cases[] = {
      {CollectionText({FeatureText(kSquare), kSquare}), "feature 1: no geometry"},
      {CollectionText({FeatureText("null")}), "feature 0: no geometry"},
      {CollectionText({FeatureText(kSquare), "7"}), "not all members"},
      {FeatureText(kSquare, R"({"centreline": "along"})"), "feature 0, property centreline: expected one LineString"},
      {FeatureText(kSquare, R"({"centreline": [[1, 1]]})"), "property centreline"},
      {FeatureText(LineText({{1, 1}})), "feature 0: expected a line of at least 2 positions"},
      {PolygonOf(""), "f: "},
      {PolygonOf("[]"), "feature 0, ring 0: expected a ring of at least 4 positions"},
      {PolygonOf("[[0, 0], [1, 0], [0, 0]]"), "feature 0, ring 0: expected a ring of at least 4 positions"},
      {PolygonOf("[[0, 0], [1, 0], [1, 1], [0, 1]]"), "feature 0, ring 0: the ring is not closed"},
      {PolygonOf("[[0, 0], [1], [1, 1], [0, 0]]"), "f: "},
      {PolygonOf("[[0, 0], [1, null], [1, 1], [0, 0]]"), "f: "},
      {PolygonOf("[[0, 0], [1, \"2\"], [1, 1], [0, 0]]"), "f: "},
      {R"({"type": "MultiPolygon", "coordinates": []})", "feature 0: a MultiPolygon without polygons"}};
  for (const BadCase& bad : cases) {
    const absl::Status status = ParseWaterFile({bad.text}, "f", {}).status();
    ASSERT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << bad.text;
    EXPECT_THAT(std::string(status.message()), StartsWith("f: ")) << bad.text;
    EXPECT_THAT(std::string(status.message()), HasSubstr(bad.message)) << bad.text;
  }
}

TEST(RawFeaturesTest, OtherGeometriesAreCountedAndLeftOut) {
  const std::string point = FeatureText(R"({"type": "Point", "coordinates": [0, 0]})", R"({"name": "Gauge"})");
  const auto file = ParseWaterFile({CollectionText({point, FeatureText(kSquare), point})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas, SizeIs(1));
  EXPECT_THAT(file->warnings,
              ElementsAre("f: feature 0 (Gauge) and 1 more: neither polygons nor lines, so they have no effect"));
  EXPECT_TRUE(ParseAreaFile({CollectionText({point, FeatureText(kSquare)})}, "f", {}).ok());
  const absl::Status none = ParseAreaFile({CollectionText({point})}, "f", {}).status();
  EXPECT_THAT(std::string(none.message()), HasSubstr("f: holds no polygon"));
}

TEST(RawFeaturesTest, AnAreaHasNoProperties) {
  EXPECT_TRUE(ParseAreaFile({FeatureText(kSquare, R"({"kind": "town", "water": "none"})")}, "f", {}).ok());
}

// As holes.geojson has them.
std::string HoleText(double x, const std::string& properties) {
  return FeatureText(PolygonText(SquareAt(x, 0, 4)), absl::StrCat(R"({"hole": 1, )", properties, "}"));
}

TEST(RawFeaturesTest, HolesAreWaterWhereTheySaySo) {
  const std::string lines = R"({"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[2,2],[3,3]]]})";
  const auto file = ParseWaterFile(
      {CollectionText({HoleText(0, R"("water": null, "kind": null)"),
                       FeatureText(lines, R"({"hole": 3, "water": null})"), HoleText(8, R"("water": false)"),
                       HoleText(16, R"("water": true, "level_m": 3)")})},
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(2));
  EXPECT_FALSE(file->areas[0].water);
  EXPECT_EQ(file->areas[1].level, 3);
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 0 and 1 more: holes whose property water is empty")));
}

TEST(RawFeaturesTest, HolesOfOneBodyAreOneAreaIfTheySayTheSame) {
  const std::string same = R"("water": true, "level_m": 3, "body": 7)";
  const auto file =
      ParseWaterFile({CollectionText({HoleText(0, same), HoleText(8, R"("water": true, "body": 8)"), HoleText(4, same),
                                      HoleText(3, same), HoleText(16, R"("water": true, "level_m": 4, "body": 7)")})},
                     "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(3));
  EXPECT_EQ(file->areas[0].label, "feature 0 and 2 more");
  for (const double x : {1., 3.5, 5., 7.}) EXPECT_TRUE(Contains(file->areas[0].polygon, {x, 1})) << x;
  EXPECT_FALSE(Contains(file->areas[0].polygon, {9, 1}));
  EXPECT_EQ(file->areas[2].level, 4);
  EXPECT_EQ(file->areas[2].label, "feature 4");
}

// As it writes level ground and ground that is none.
constexpr char kLevelGround[] =
    R"("cluster": 3, "level_m": 5, "estimate_m": 5, "sigma_m": 0.1, "decided_by": "rim", "taken_for": "level")";
constexpr char kGround[] = R"("cluster": 3, "decided_by": null, "taken_for": "ground")";
constexpr char kLake[] = R"("cluster": 3, "water": true, "kind": "lake", "level_m": 5, "estimate_m": 5,
                            "sigma_m": 0.1, "decided_by": "rim", "taken_for": "lake", "body": 0)";

std::string Changed(const std::string& row, const std::string& change) { return absl::StrCat(row, ", ", change); }

TEST(RawFeaturesTest, AllRowsOfAHoleFollowTheOneThatIsChanged) {
  const auto file = ParseWaterFile(
      {CollectionText({HoleText(0, kGround), HoleText(8, Changed(kGround, R"("water": true, "level_m": 4)")),
                       HoleText(16, kLevelGround), HoleText(24, R"("cluster": 4)")})},
      "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  ASSERT_THAT(file->areas, SizeIs(3));
  for (const WaterArea& area : file->areas) {
    EXPECT_TRUE(area.water) << area.label;
    EXPECT_EQ(area.level, 4) << area.label;
  }
  EXPECT_THAT(file->warnings, ElementsAre(HasSubstr("f: feature 3: holes whose property water is empty")));
}

TEST(RawFeaturesTest, TheDryPartOfAHoleThatIsWaterStaysDry) {
  const auto file =
      ParseWaterFile({CollectionText({HoleText(0, kLake), HoleText(8, Changed(kLake, R"("clear": false)")),
                                      HoleText(16, kGround), HoleText(24, Changed(kGround, R"("water": true)"))})},
                     "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_THAT(file->areas, SizeIs(2)) << "one body, and the row that says it is water";
}

TEST(RawFeaturesTest, ChangesOfHolesThatAreNoWaterAreTold) {
  const auto told =
      ParseWaterFile({CollectionText({HoleText(0, kLevelGround), HoleText(8, kLevelGround),
                                      HoleText(16, Changed(kGround, R"("level_m": 4)")),
                                      HoleText(24, Changed(kGround, R"("clear": true)")), FeatureText(kSquare)})},
                     "f", {});
  ASSERT_TRUE(told.ok()) << told.status();
  EXPECT_THAT(told->areas, SizeIs(1));
  EXPECT_THAT(told->warnings, UnorderedElementsAre(HasSubstr("feature 0 and 1 more: holes whose property water is"),
                                                   HasSubstr("feature 2 and 1 more: holes that were changed but")));
}

TEST(RawFeaturesTest, EstimatesMayBeTextButNotDamaged) {
  const std::string text = R"("water": true, "kind": "lake", "level_m": "5", "estimate_m": "5 m", "sigma_m": "0.1",
                              "decided_by": "rim", "taken_for": "lake")";
  const auto file = ParseWaterFile({CollectionText({HoleText(0, text)})}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_TRUE(file->areas[0].is_as_found);
  EXPECT_EQ(file->areas[0].level_sigma, 0.1);
  for (const char* damage : {R"("estimate_m": "#VALUE!")", R"("sigma_m": -1)", R"("sigma_m": [1])"}) {
    const auto damaged = ParseWaterFile({CollectionText({HoleText(0, Changed(kGround, damage))})}, "f", {});
    EXPECT_THAT(damaged.status().ToString(), HasSubstr("f: feature 0: property ")) << damage;
  }
}

}  // namespace
}  // namespace tilemend
