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

TEST(JsonAccessTest, WhatIsNestedTooDeepIsLeftOut) {
  const std::string deep(100000, '['), end(100000, ']');
  const auto json = ParseShallow(R"({"a": [1, {"b": 2}], "look_at": )" + deep + end + "}");
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["a"].dump(), R"([1,{"b":2}])");
  EXPECT_LT(json.dump().size(), 1000u);
  EXPECT_TRUE(ParseShallow("{").is_discarded());
}

}  // namespace
}  // namespace tilemend
