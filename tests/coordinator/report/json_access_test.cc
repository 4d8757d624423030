#include "coordinator/report/json_access.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonAccessTest, WhatIsMissingOrOfAnotherTypeIsEmpty) {
  EXPECT_TRUE(Member(Json(), "a").is_null());
  EXPECT_TRUE(Member(Json{{"b", 1}}, "a").is_null());
  EXPECT_EQ(Member(Json{{"a", 1}}, "a"), 1);
  EXPECT_EQ(Text(Json()), "");
  EXPECT_EQ(Text(Json("x")), "x");
  EXPECT_EQ(Text(Json{1, 2}), "[1,2]");
  EXPECT_EQ(Number(Json("x")), 0);
  EXPECT_EQ(Number(Json(2.5)), 2.5);
  EXPECT_EQ(Decimals(Json("x"), 1), "x");
}

TEST(JsonAccessTest, HalvesAreRoundedAsOnThePage) {
  EXPECT_EQ(Decimals(Json(2.25), 1), "2.3");
  EXPECT_EQ(Decimals(Json(-2.25), 1), "-2.3");
  EXPECT_EQ(Decimals(Json(1.8005), 3), "1.801");
  EXPECT_EQ(Decimals(Json(1.0005), 3), "1.001");
  EXPECT_EQ(Decimals(Json(1.80049), 3), "1.800");
  EXPECT_EQ(Decimals(Json(7), 2), "7.00");
  EXPECT_EQ(Decimals(Json(1e300), 0).size(), 301U);
}

TEST(JsonAccessTest, AreasHaveOneFormHoweverSmallTheyAre) {
  EXPECT_EQ(AreaText(Json(-3)), "3.0");
  EXPECT_EQ(AreaText(Json(12.34)), "12.3");
  EXPECT_EQ(AreaText(Json(0.5)), "0.5");
  EXPECT_EQ(AreaText(Json(0.1)), "0.1");
  EXPECT_EQ(AreaText(Json(0.0999)), "< 0.1");
  EXPECT_EQ(AreaText(Json(-0.0042)), "< 0.1");
  EXPECT_EQ(AreaText(0.00001), "< 0.1");
  EXPECT_EQ(AreaText(0.0), "0.0");
  EXPECT_EQ(AreaText(Json()), "-");
}

TEST(JsonAccessTest, AreasMayHaveMoreDecimals) {
  EXPECT_EQ(AreaText(0.0042, 3), "0.004");
  EXPECT_EQ(AreaText(Json(0.00042), 3), "< 0.001");
  EXPECT_EQ(AreaText(Json(0), 3), "0.000");
}

TEST(JsonAccessTest, CentresOfASceneHaveTwoDecimals) {
  EXPECT_EQ(CentreText(Json({54.1476, 1748.7705})), "[54.15,1748.77]");
  EXPECT_EQ(CentreText(Json({215.0, 150})), "[215.00,150.00]");
  EXPECT_EQ(CentreText(Json({0.00125, 2.5, 3.5})), "[0.00125,2.5,3.5]");
  EXPECT_EQ(CentreText(Json()), "");
}

}  // namespace
}  // namespace tilemend
