#include "coordinator/report/shallow_json.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

TEST(ShallowJsonTest, ReadsWhatTheLibraryReads) {
  for (const char* text : {R"({"b": [1, -2, 2.5, "x", true, null, [], {}], "a": {"c": {"d": [[1], [2, [3]]]}}})", "[]",
                           "{}", "3", "\"x\"", R"({"a": 1, "b": 2, "a": 3})", "[18446744073709551615, 1e300]"}) {
    EXPECT_EQ(ParseShallow(text).dump(), Json::parse(text).dump()) << text;
  }
  for (const char* text : {"", "{", "[1,]", "[1] 2", "[1e999]", "{\"a\" 1}", "[\"\xff\"]"}) {
    EXPECT_TRUE(ParseShallow(text).is_discarded()) << text;
  }
}

TEST(ShallowJsonTest, WhatIsNestedTooDeepIsLeftOut) {
  const std::string deep(100000, '['), end(100000, ']');
  const Json json = ParseShallow(R"({"a": [1, {"b": 2}], "look_at": )" + deep + end + R"(, "c": 3})");
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["a"].dump(), R"([1,{"b":2}])");
  EXPECT_EQ(json["c"], 3);
  EXPECT_LT(json.dump().size(), 1000U);
  std::string objects = "1";
  for (int i = 0; i < 1000; ++i) objects = R"({"a": )" + objects + R"(, "b": 2})";
  EXPECT_EQ(ParseShallow(objects)["b"], 2);
  EXPECT_LT(ParseShallow(objects).dump().size(), 1000U);
}

TEST(ShallowJsonTest, WhatIsNotToBeKeptIsDropped) {
  const auto keep = [](int depth, const Json& value) { return depth != 2 || value.contains("kept"); };
  const Json json =
      ParseShallow(R"({"a": [{"kept": 1}, {"x": {"kept": 2}}, [4], 5, {"kept": {}}], "b": {"c": {}}})", {.keep = keep});
  EXPECT_EQ(json.dump(), R"({"a":[{"kept":1},5,{"kept":{}}],"b":{}})");
}

TEST(ShallowJsonTest, EndsWhenItIsToStop) {
  std::stop_source source;
  int read = 0;
  const auto keep = [&](int, const Json&) {
    if (++read == 2) source.request_stop();
    return true;
  };
  EXPECT_TRUE(ParseShallow("[[], [], [], [], []]", {.keep = keep, .stop = source.get_token()}).is_discarded());
  EXPECT_EQ(read, 2);
}

}  // namespace
}  // namespace tilemend
