#include "coordinator/report/cleared_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::ordered_json;

std::vector<ClearedArea> Cleared() {
  return {{"feature 0 (pond)", true, 4.7512345, {{{0, 1}, 30}, {{1, 1}, 12}}},
          {"feature 1", false, std::nullopt, {{{1, 1}, 5}}},
          {"feature 2 (dry)", true, 2.5, {}},
          {"feature 3", false, std::nullopt, {}},
          {"feature 4", true, std::nullopt, {}}};
}

TEST(ClearedReportTest, CountsInAllByTileAndByArea) {
  const Json json = ClearedJson(Cleared(), {});
  EXPECT_EQ(json["triangles"], 47);
  EXPECT_EQ(json["tiles"], Json::parse(R"([{"cell": [0, 1], "triangles": 30}, {"cell": [1, 1], "triangles": 17}])"));
  ASSERT_EQ(json["areas"].size(), 5U);
  EXPECT_EQ(json["areas"][0], Json::parse(R"json({"feature": "feature 0 (pond)", "water": true, "top_m": 4.7512,
      "triangles": 42, "tiles": [{"cell": [0, 1], "triangles": 30}, {"cell": [1, 1], "triangles": 12}]})json"));
  EXPECT_FALSE(json["areas"][1].contains("top_m"));
}

TEST(ClearedReportTest, TilesThatAreNotWrittenDoNotCount) {
  const Json json = ClearedJson(Cleared(), {{1, 1}});
  EXPECT_EQ(json["triangles"], 17);
  EXPECT_EQ(json["areas"][0]["triangles"], 12);
}

TEST(ClearedReportTest, WarnsOfAreasThatTookNothing) {
  EXPECT_THAT(
      ClearedWarnings(Cleared()),
      ElementsAre("polygon feature 2 (dry): nothing was taken out: no triangle below 2.50 m lies in it by more "
                  "than 10 % of its area",
                  "polygon feature 3: nothing was taken out: no triangle lies in it by more than 10 % of its area",
                  "polygon feature 4: nothing was taken out: it has no level, because no triangle has its middle in "
                  "it; give it a level"));
}

}  // namespace
}  // namespace tilemend
