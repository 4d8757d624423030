#include "common/grid/json_text.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace tilemend {
namespace {

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
  const absl::Status status = ParseJson("{\n \"a\": 1,\n \"\u00fc\": ]\n}", "a.json").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(status.message(), "a.json: not JSON: byte 19 (line 3, column 7): ] is not expected here");
}

TEST(ParseJsonTest, SaysInPlainWordsWhatIsWrong) {
  const std::map<std::string, std::string> cases = {
      {"", "byte 1 (line 1, column 1): the file is empty"},
      {"{\"a\": [1, 2", "byte 12 (line 1, column 12): the file ends before the JSON does"},
      {"{\"a\": \"b", "byte 9 (line 1, column 9): the file ends before the JSON does"},
      {"{\"a\": 1,}", "byte 9 (line 1, column 9): a comma too many before }"},
      {"[1, 2,\n]", "byte 8 (line 2, column 1): a comma too many before ]"},
      {"{'a': 1}", "byte 2 (line 1, column 2): ' is not expected here; names and texts are written in double quotes"},
      {"{\"a\" 1}", "byte 6 (line 1, column 6): 1 is not expected here"},
      {"{} {}", "byte 4 (line 1, column 4): more text behind the end of the JSON"},
      {"[1e999]", "byte 6 (line 1, column 6): a number that is too large"},
      {"[\"\xff\"]", "byte 3 (line 1, column 3): a text with bytes that are not UTF-8"},
      {"[\"a\nb\"]",
       "byte 4 (line 1, column 4): a line break or control character inside quotes; is a closing quote missing?"},
      {R"(["\x"])", "byte 4 (line 1, column 4): a backslash that begins no character"}};
  for (const auto& [text, reason] : cases) {
    EXPECT_EQ(ParseJson(text, "a.json").status().message(), "a.json: not JSON: " + reason) << text;
  }
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
