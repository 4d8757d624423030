#include "coordinator/report/planned_holes.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

Plan ThreeHoles() {
  Plan plan;
  plan.holes.resize(3);
  plan.holes[0].cell = plan.holes[1].cell = {1, 2};
  plan.holes[0].area = 4;
  plan.holes[0].centre = {10.25, 7};
  plan.holes[1].area = 400;
  plan.holes[2].cell = {3, 2};
  plan.holes[2].area = 1;
  plan.holes[2].failure = "its boundary crosses itself";
  return plan;
}

TEST(PlannedHolesTest, WhatStaysOpenComesFirstThenTheLargest) {
  const Json json = Json::parse(PlannedHolesJson(ThreeHoles(), {}, 10));
  EXPECT_EQ(json["holeCount"], 3);
  EXPECT_EQ(json["planned"], true);
  ASSERT_EQ(json["holes"].size(), 3);
  EXPECT_EQ(json["holes"][0]["id"], 2);
  EXPECT_EQ(json["holes"][0]["reason"], "its boundary crosses itself");
  EXPECT_EQ(json["holes"][1]["id"], 1);
  EXPECT_EQ(json["holes"][2]["centre"], Json({10.25, 7}));
  EXPECT_EQ(json["holes"][2]["kind"], "closed");
  EXPECT_EQ(json["holes"][0]["filled"], false);
  EXPECT_EQ(json["holes"][2]["filled"], true);
}

TEST(PlannedHolesTest, OnlyHolesOfChosenCellsAndNoMoreThanAsked) {
  const Json chosen = Json::parse(PlannedHolesJson(ThreeHoles(), {{1, 2}}, 1));
  EXPECT_EQ(chosen["holeCount"], 2);
  ASSERT_EQ(chosen["holes"].size(), 1);
  EXPECT_EQ(chosen["holes"][0]["id"], 1);
}

}  // namespace
}  // namespace tilemend
