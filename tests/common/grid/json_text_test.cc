#include "common/grid/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ParseJsonTest, ReadsEveryKindOfValue) {
  const std::string text = R"({"a": [1, -2, 2.5, 18446744073709551615, true, null, "\u00fc"], "b": {"c": {}}})";
  const auto json = ParseJson(text, "a.json");
  ASSERT_TRUE(json.ok()) << json.status();
  EXPECT_EQ(json->at("a").at(1), -2);
  EXPECT_EQ(json->at("a").at(3), 18446744073709551615u);
  EXPECT_TRUE(json->at("a").at(5).is_null());
  EXPECT_EQ(json->at("a").at(6), "\u00fc");
  EXPECT_TRUE(json->at("b").at("c").empty());
}

TEST(ParseJsonTest, NamesFileAndPlaceOfWhatIsWrong) {
  const absl::Status status = ParseJson("{\n \"a\": 1,\n \"b\": ]\n}", "a.json").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  const std::string message(status.message());
  EXPECT_THAT(message, HasSubstr("a.json: not JSON: byte 18: "));
  EXPECT_THAT(message, HasSubstr("line 3, column 7"));
  EXPECT_THAT(message, Not(HasSubstr("json.exception")));
}

TEST(ParseJsonTest, RefusesWhatIsNoJson) {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("{} {}"), std::string("nan"), std::string("{'a': 1}"),
        std::string("1e999"), std::string("\"\xff\""), std::string(100'000, '[')}) {
    EXPECT_EQ(ParseJson(text, "a").status().code(), absl::StatusCode::kInvalidArgument) << text.substr(0, 20);
  }
}

}  // namespace
}  // namespace tilemend
