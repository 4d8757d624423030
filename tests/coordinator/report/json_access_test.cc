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
  EXPECT_EQ(Decimals(Json(2.25), 1), "2.2");
  EXPECT_EQ(AreaText(Json(-3)), "3.0");
}

}  // namespace
}  // namespace tilemend
