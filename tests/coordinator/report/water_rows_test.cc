#include "coordinator/report/water_rows.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// A closed hole, and two open ones of cluster 0, of which the second is left open.
class WaterRowsTest : public ::testing::Test {
 protected:
  WaterRowsTest() {
    plan_.holes.resize(3);
    for (const int h : {1, 2}) {
      plan_.holes[h].kind = HoleKind::kOpenI;
      plan_.holes[h].cluster = 0;
    }
    input_.plan = &plan_;
    input_.outcome.failures = {{2, "no way was found"}};
  }

  Plan plan_;
  SceneReportInput input_;
};

TEST_F(WaterRowsTest, NamesTheClusterOfALakeThatAClosedHoleIsAPartOf) {
  plan_.holes[0].water = plan_.holes[1].water = 0;
  plan_.water = {{BodyKind::kWater, {0, 1}, 12.5, {}, {}, 0.01, 12.4, 12.6, 9, true}};
  EXPECT_EQ(WaterRows(input_)[0]["cluster"], 0);
}

TEST_F(WaterRowsTest, LeavesOutWaterWhoseHolesAllFailed) {
  plan_.holes[2].water = 0;
  plan_.water = {{BodyKind::kWater, {2}, 12.5, {}, {}, 0.01, 12.4, 12.6, 9, false}};
  EXPECT_TRUE(WaterRows(input_).empty());
}

TEST_F(WaterRowsTest, AnswersEveryAreaOfWater) {
  plan_.water = {{BodyKind::kWater, {1}, 12.5, {}, {}}};
  plan_.holes[1].water = 0;
  plan_.water_answers = {{"feature 0", true, true, {1}, ""}, {"feature 1", false, false, {}, "why"}};
  const Json rows = WaterAreaRows(plan_);
  EXPECT_EQ(rows, Json::parse(R"([{"feature": "feature 0", "water": true, "taken": true, "holes": [1], "level_m": 12.5},
                                  {"feature": "feature 1", "water": false, "taken": false, "reason": "why"}])"));
}

TEST_F(WaterRowsTest, ALevelThatAPolygonGivesHasNoSigma) {
  plan_.water = {{BodyKind::kWater, {0}, 12.5, {}, {}, 0.04}, {BodyKind::kWater, {1}, 12.5, {}, {}, 0.04}};
  plan_.water[1].level_is_given = true;
  const Json rows = WaterRows(input_);
  EXPECT_EQ(rows[0]["sigma_m"], 0.04);
  EXPECT_TRUE(rows[1]["sigma_m"].is_null());
  EXPECT_EQ(rows[1]["body"], 1);
}

}  // namespace
}  // namespace tilemend
