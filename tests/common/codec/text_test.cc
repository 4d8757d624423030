#include "common/codec/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace tilemend {
namespace {

ParsedDouble Double(const std::string& text) { return ParseDoubleAt(text.data(), text.data() + text.size()); }

TEST(ParseDoubleAtTest, ReadsANumberAndNoMore) {
  const std::string text = "+1.5e3,7";
  const ParsedDouble parsed = ParseDoubleAt(text.data(), text.data() + text.size());
  EXPECT_EQ(parsed.value, 1500);
  EXPECT_EQ(parsed.stop, text.data() + 6);
  EXPECT_EQ(Double("-0.1").value, -0.1);
  for (const char* none : {"", "+", "-", "x1", " 1", "+-1", ".", "e5"}) EXPECT_EQ(Double(none).stop, nullptr) << none;
}

TEST(ParseIntegerAtTest, ReadsWhatFitsInto64Bits) {
  const auto parse = [](const std::string& text) { return ParseIntegerAt(text.data(), text.data() + text.size()); };
  EXPECT_EQ(parse("-12x").value, -12);
  EXPECT_EQ(parse("+7").value, 7);
  EXPECT_EQ(parse("9223372036854775807").value, std::numeric_limits<int64_t>::max());
  for (const char* none : {"", "9223372036854775808", "+-7", "one"}) EXPECT_EQ(parse(none).stop, nullptr) << none;
}

TEST(AppendNumberTest, WritesTheShortestTextThatReadsBack) {
  std::string text;
  AppendNumber(0.1, text);
  AppendNumber(int64_t{-42}, text);
  EXPECT_EQ(text, "0.1-42");
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 150);
    std::string number;
    AppendNumber(value, number);
    EXPECT_EQ(Double(number).value, value) << number;
  }
}

TEST(IsValidCoordinateTest, RefusesWhatIsNoPlace) {
  EXPECT_TRUE(IsValidCoordinate(-1e9));
  EXPECT_FALSE(IsValidCoordinate(1.0000001e9));
  EXPECT_FALSE(IsValidCoordinate(std::nan("")));
  EXPECT_FALSE(IsValidCoordinate(-std::numeric_limits<double>::infinity()));
}

TEST(LineEndingOfTest, GoesByTheFirstLine) {
  EXPECT_EQ(LineEndingOf("a\r\nb\n"), "\r\n");
  EXPECT_EQ(LineEndingOf("a\nb\r\n"), "\n");
  EXPECT_EQ(LineEndingOf("a\rb"), "\r");
  EXPECT_EQ(LineEndingOf("a\rb\n"), "\n");
  EXPECT_EQ(LineEndingOf("no end"), "\n");
  EXPECT_EQ(LineEndingOf("\n"), "\n");
}

TEST(FurtherColumnsTest, AreTheWordsUpToTheLineEnd) {
  EXPECT_EQ(FurtherColumns("  0.5\t 1e2 # red\n9", '\n', false), " 0.5 1e2");
  EXPECT_EQ(FurtherColumns("1 2\n3", '\n', true), " 1 2 3");
  EXPECT_EQ(FurtherColumns("1 # x\n 2", '\n', true), " 1 2");
  EXPECT_EQ(FurtherColumns("", '\n', false), "");
}

TEST(FurtherColumnsTest, GoOnBehindABackslash) {
  EXPECT_EQ(FurtherColumns("1 \\\n2\n3", '\n', false), " 1 2");
  EXPECT_EQ(FurtherColumns("1\\\r\n2\n3", '\n', false), " 1 2");
  EXPECT_EQ(FurtherColumns("1 \\ 2\n3", '\n', false), " 1 0 2");
}

TEST(FurtherColumnsTest, HoldNumbersAloneAndNotTooMany) {
  EXPECT_EQ(FurtherColumns("red 1x nan 0.5", '\n', false), " 0 0 nan 0.5");
  EXPECT_EQ(FurtherColumns(std::string(65, '1'), '\n', false), " 0");
  std::string many;
  for (int i = 0; i < 30; ++i) many += "7 ";
  EXPECT_EQ(FurtherColumns(many, '\n', false).size(), 32u);
}

TEST(QuotedAtTest, ShowsAWordInPrint) {
  EXPECT_EQ(QuotedAt("a bc d", 2), "'bc'");
  EXPECT_EQ(QuotedAt("a\n", 1), "end of line");
  EXPECT_EQ(QuotedAt("a", 1), "end of file");
  EXPECT_EQ(QuotedAt("\xff\x01", 0), "'\\xff\\x01'");
  EXPECT_EQ(QuotedAt(std::string(41, 'x'), 0), "'" + std::string(40, 'x') + "...'");
  EXPECT_EQ(QuotedAt(std::string(40, 'x'), 0), "'" + std::string(40, 'x') + "'");
}

TEST(FoundAtTest, ShowsNumbersAlone) {
  EXPECT_EQ(FoundAt("a -1.5e3 d", 2), "'-1.5e3'");
  EXPECT_EQ(FoundAt("f 1/2", 2), "'1/2'");
  for (const char* secret : {"password", "root:x:0:0", "7f3a9", "12:34", "1 2"}) {
    EXPECT_EQ(FoundAt(secret, 0), secret[1] == ' ' ? "'1'" : "something else") << secret;
  }
  EXPECT_EQ(FoundAt(std::string(40, '1'), 0), "something else");
  EXPECT_EQ(FoundAt("a\n", 1), "end of line");
  EXPECT_EQ(FoundAt("a", 1), "end of file");
}

TEST(LineErrorTest, NamesTheLine) {
  EXPECT_EQ(LineError("a.obj", "v 1\nv x\n", 6, "a number").message(),
            "a.obj: line 2: expected a number, found something else");
  EXPECT_EQ(LineProblem("a.obj", "v\rw\rx", 4, "bad").message(), "a.obj: line 3: bad");
  EXPECT_EQ(LineProblem("a.obj", "v\n", 99, "bad").message(), "a.obj: line 2: bad");
  EXPECT_EQ(ByteProblem("a.ply", 7, "bad").message(), "a.ply: byte 7: bad");
}

}  // namespace
}  // namespace tilemend
