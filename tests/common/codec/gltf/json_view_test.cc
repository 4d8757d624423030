#include "common/codec/gltf/json_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

const std::string kFile = "a.json";

std::string ParseMessage(std::string_view text) {
  return std::string(ParseOrderedJson(text, 20, kFile).status().message());
}

template <typename T>
std::string MessageOf(const absl::StatusOr<T>& result) {
  return std::string(result.status().message());
}

TEST(ParseOrderedJsonTest, KeepsTheOrder) {
  const absl::StatusOr<OrderedJson> json = ParseOrderedJson(R"({"b":1,"a":[2.5,"x"]})", 0, kFile);
  ASSERT_TRUE(json.ok()) << json.status();
  EXPECT_EQ(json->dump(), R"({"b":1,"a":[2.5,"x"]})");
}

TEST(ParseOrderedJsonTest, NamesTheByteOfTheFile) {
  EXPECT_EQ(ParseMessage("{\"a\":]"), "a.json: byte 25: not JSON");
  EXPECT_EQ(ParseMessage(""), "a.json: byte 20: not JSON");
  EXPECT_EQ(ParseMessage("{} x"), "a.json: byte 23: not JSON");
}

TEST(ParseOrderedJsonTest, LimitsTheDepth) {
  const auto nested = [](size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(ParseMessage(nested(250)), "");
  EXPECT_EQ(ParseMessage(nested(251)), "a.json: byte 20: JSON nests deeper than 250 levels");
  EXPECT_THAT(ParseMessage(std::string(1000000, '[')), testing::HasSubstr("nests deeper"));
}

TEST(ParseOrderedJsonTest, LimitsTheMembersOfAnObject) {
  std::string text = "{\"m0\":0";
  for (int i = 1; i < 1024; ++i) text += ",\"m" + std::to_string(i) + "\":0";
  EXPECT_EQ(ParseMessage(text + "}"), "");
  EXPECT_EQ(ParseMessage(text + ",\"last\":0}"), "a.json: byte 20: an object has more than 1024 members");
}

class JsonViewTest : public testing::Test {
 protected:
  const OrderedJson json_ = OrderedJson::parse(
      R"({"n":3,"f":2.5,"t":"x","y":true,"a":[1,2,3],"o":{"a/b~c":{"x":-1}},"extensions":{"E":{"k":1}}})");
  const JsonView view_{json_, kFile};
};

TEST_F(JsonViewTest, ReadsMembers) {
  EXPECT_EQ(view_.Integer("n", 0, 3).value(), 3);
  EXPECT_EQ(view_.IntegerOr("none", 0, 3, 2).value(), 2);
  EXPECT_EQ(view_.TextOr("t", "").value(), "x");
  EXPECT_EQ(view_.TextOr("none", "y").value(), "y");
  EXPECT_TRUE(view_.BoolOr("y", false).value());
  EXPECT_TRUE(view_.BoolOr("none", true).value());
  EXPECT_THAT(view_.NumbersOr("a", {0, 0, 0}).value(), testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(view_.NumbersOr("none", {7}).value(), testing::ElementsAre(7));
  EXPECT_EQ(view_.Elements("a")->size(), 3u);
  EXPECT_TRUE(view_.Elements("none")->empty());
  EXPECT_EQ(view_.Extension("E")->Integer("k", 0, 9).value(), 1);
  EXPECT_FALSE(view_.Extension("F").has_value());
}

TEST_F(JsonViewTest, ErrorsNameThePath) {
  EXPECT_EQ(MessageOf(view_.Get("none")), "a.json: JSON /: expected a member \"none\"");
  EXPECT_EQ(MessageOf(view_.Integer("n", 0, 2)), "a.json: JSON /n: expected an integer in 0 to 2");
  EXPECT_EQ(MessageOf(view_.Integer("f", 0, 9)), "a.json: JSON /f: expected an integer in 0 to 9");
  EXPECT_EQ(MessageOf(view_.Get("t")->AsNumber()), "a.json: JSON /t: expected a finite number");
  EXPECT_EQ(MessageOf(view_.TextOr("n", "")), "a.json: JSON /n: expected a text");
  EXPECT_EQ(MessageOf(view_.BoolOr("n", true)), "a.json: JSON /n: expected true or false");
  EXPECT_EQ(MessageOf(view_.NumbersOr("a", {0, 0})), "a.json: JSON /a: expected 2 numbers");
  EXPECT_EQ(MessageOf(view_.Get("a")->At(3)), "a.json: JSON /a: no element 3");
  EXPECT_EQ(MessageOf(view_.At(0)), "a.json: JSON /: expected an array");
  EXPECT_EQ(MessageOf(view_.Elements("n")), "a.json: JSON /n: expected an array");
  EXPECT_EQ(MessageOf(view_.Get("o")->Get("a/b~c")->Integer("x", 0, 1)),
            "a.json: JSON /o/a~1b~0c/x: expected an integer in 0 to 1");
}

}  // namespace
}  // namespace tilemend
