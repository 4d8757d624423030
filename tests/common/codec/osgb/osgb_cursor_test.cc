#include "common/codec/osgb/osgb_cursor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

using ::testing::HasSubstr;

const std::string kName = "a.osgb";

std::string MessageOf(const OsgbCursor& cursor) { return std::string(cursor.status().message()); }

TEST(OsgbCursorTest, ReadsLittleEndianNumbers) {
  const std::string bytes("\x01\x02\x03\x84\x01\0\0\x80\x3f\0\0\0\0\0\0\xf8\x3f\x02\0\0\0ab", 23);
  OsgbCursor cursor(bytes, kName);
  EXPECT_EQ(cursor.U32("a number"), 0x84030201u);
  EXPECT_TRUE(cursor.Flag("a flag"));
  EXPECT_EQ(cursor.F32("a float"), 1.0F);
  EXPECT_EQ(cursor.F64("a double"), 1.5);
  EXPECT_EQ(cursor.String("a text"), "ab");
  EXPECT_TRUE(cursor.ok());
  EXPECT_EQ(cursor.remaining(), 0u);
}

TEST(OsgbCursorTest, KeepsTheFirstFailure) {
  const std::string bytes("\x01\x02\x03", 3);
  OsgbCursor cursor(bytes, kName);
  cursor.Flag("a flag");
  EXPECT_EQ(cursor.U32("the first number"), 0u);
  EXPECT_EQ(cursor.U32("the second number"), 0u);
  EXPECT_FALSE(cursor.Flag("a flag"));
  EXPECT_EQ(cursor.offset(), 1u);
  EXPECT_EQ(MessageOf(cursor), "a.osgb: byte 1: expected the first number (4 bytes); the file ends after 2");
}

TEST(OsgbCursorTest, RefusesCountsThatTheRestCannotHold) {
  const std::string bytes("\x02\0\0\0\0\0\0\0\0\0\0\0", 12);
  OsgbCursor fits(bytes, kName);
  EXPECT_EQ(fits.Count(4, "numbers"), 2u);
  OsgbCursor too_large(bytes, kName);
  EXPECT_EQ(too_large.Count(5, "numbers"), 0u);
  EXPECT_EQ(MessageOf(too_large), "a.osgb: byte 0: numbers: the count of 2 is too large for the rest of the file");
}

TEST(OsgbCursorTest, EscapesAndShortensNamesInMessages) {
  OsgbCursor cursor("", kName);
  cursor.Fail("\x1b[2J" + std::string(1000, 'x'));
  EXPECT_THAT(MessageOf(cursor), HasSubstr("\\x1b[2J"));
  EXPECT_LT(MessageOf(cursor).size(), 300u);
}

TEST(OsgbCursorTest, BracketsNestAndMustEndWhereTheySay) {
  const std::string bytes("\x0c\0\0\0\x05\0\0\0\x01\x02\x03\x04", 12);
  OsgbCursor cursor(bytes, kName);
  cursor.SetBracketBytes(4);
  EXPECT_EQ(cursor.bracket(), -1);
  cursor.Begin("outer");
  cursor.Begin("inner");
  EXPECT_EQ(cursor.bracket(), 1);
  cursor.Flag("a flag");
  cursor.End("inner");
  EXPECT_EQ(cursor.bracket(), 0);
  EXPECT_TRUE(cursor.ok());
  ASSERT_EQ(cursor.brackets().size(), 2u);
  EXPECT_EQ(cursor.brackets()[1].offset, 4u);
  EXPECT_EQ(cursor.brackets()[1].parent, 0);
  cursor.End("outer");
  EXPECT_EQ(MessageOf(cursor), "a.osgb: byte 9: outer: the bracket opened at byte 0 ends at byte 12");
}

TEST(OsgbCursorTest, RefusesBracketsThatReachBeyondTheFileOrEndInTheirSize) {
  for (const char size : {3, 5}) {
    const std::string bytes{size, 0, 0, 0};
    OsgbCursor cursor(bytes, kName);
    cursor.SetBracketBytes(4);
    cursor.Begin("a list");
    EXPECT_THAT(MessageOf(cursor), HasSubstr("byte 0: a list: a bracket of")) << int{size};
  }
}

TEST(OsgbCursorTest, BracketsOfAFileWithoutThemTakeNoBytes) {
  OsgbCursor cursor("", kName);
  cursor.Begin("a list");
  cursor.End("a list");
  EXPECT_TRUE(cursor.ok());
  EXPECT_TRUE(cursor.brackets().empty());
}

}  // namespace
}  // namespace tilemend
