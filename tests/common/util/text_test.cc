#include "common/util/text.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

TEST(TextTest, TellsUtf8) {
  for (const char* text :
       {"", "plain", "Z\xc3\xbcrich", "\xe6\xb9\x96", "\xf0\x9f\x8c\x8d", "\xed\x9f\xbf", "\xf4\x8f\xbf\xbf"})
    EXPECT_TRUE(IsUtf8(text)) << Printable(text);
  for (const char* text : {"\xff", "\x80", "Z\xfcrich", "\xc3", "\xe6\xb9", "\xf0\x9f\x8c", "\xc0\xaf", "\xe0\x80\xaf",
                           "\xf0\x80\x80\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "a\xc3z"}) {
    EXPECT_FALSE(IsUtf8(text)) << Printable(text);
  }
}

TEST(TextTest, CountsTheColumnsOfATerminal) {
  EXPECT_EQ(ColumnsOf(""), 0U);
  EXPECT_EQ(ColumnsOf("plain"), 5U);
  EXPECT_EQ(ColumnsOf("Z\xc3\xbcrich"), 6U);
  EXPECT_EQ(ColumnsOf("Zu\xcc\x88rich"), 6U);                 // a diaeresis that combines
  EXPECT_EQ(ColumnsOf("\xe8\xa5\xbf\xe6\xb9\x96"), 4U);       // an ideograph takes two
  EXPECT_EQ(ColumnsOf("\xea\xb0\x95\xf0\x9f\x8c\x8a!"), 5U);  // so do Hangul and emoji
}

TEST(TextTest, CutsBetweenCharacters) {
  EXPECT_EQ(CutToColumns("Z\xc3\xbcrich", 2), "Z\xc3\xbc");
  EXPECT_EQ(CutToColumns("Z\xc3\xbcrich", 60), "Z\xc3\xbcrich");
  EXPECT_EQ(CutToColumns("\xe8\xa5\xbf\xe6\xb9\x96", 3), "\xe8\xa5\xbf");
  EXPECT_EQ(CutToColumns("abc", 0), "");
}

TEST(TextTest, PrintsOneLineOfUtf8) {
  EXPECT_EQ(Printable("Z\xc3\xbcrich"), "Z\xc3\xbcrich");
  EXPECT_EQ(Printable("a\nb\x7f"),
            "a\\x0a"
            "b\\x7f");
  EXPECT_EQ(Printable("Z\xfcrich"), "Z\\xfcrich");
  EXPECT_EQ(Printable(std::string("\0", 1)), "\\x00");
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_TRUE(IsUtf8(Printable(all)));
}

TEST(PrintableTest, LeavesNothingThatSteersATerminal) {
  EXPECT_EQ(Printable("\x1b[31m"), "\\x1b[31m");
  EXPECT_EQ(Printable("a\xc2\x9b"
                      "31m"),
            "a\\xc2\\x9b31m");                                           // CSI
  EXPECT_EQ(Printable("\xe2\x80\xaegpj"), "\\xe2\\x80\\xaegpj");         // right to left
  EXPECT_EQ(Printable("\xe2\x81\xa6x"), "\\xe2\\x81\\xa6x");             // isolate
  EXPECT_EQ(Printable("\xc2\xa0\xe2\x82\xac"), "\xc2\xa0\xe2\x82\xac");  // a space that does not break, a euro
}

TEST(SqueezedToTest, ShowsBothEndsAndNeverMoreColumns) {
  EXPECT_EQ(SqueezedTo("abc", 3), "abc");
  EXPECT_EQ(SqueezedTo("abcdefghij", 9), "ab...ghij");
  EXPECT_EQ(SqueezedTo("abcdefghij", 3), "abc");
  const std::string wide = "\xe6\xbc\xa2\xe6\xbc\xa2\xe6\xbc\xa2\xe6\xbc\xa2\xe6\xbc\xa2\xe6\xbc\xa2";  // 12 columns
  for (size_t columns = 0; columns < 14; ++columns) {
    EXPECT_LE(ColumnsOf(SqueezedTo(wide, columns)), columns);
    EXPECT_TRUE(IsUtf8(SqueezedTo(wide, columns)));
  }
}

TEST(EditDistanceTest, CountsWhatIsPutInTakenOutOrChanged) {
  EXPECT_EQ(EditDistance("water", "water"), 0U);
  EXPECT_EQ(EditDistance("water", "watr"), 1U);
  EXPECT_EQ(EditDistance("water", "layer"), 2U);
  EXPECT_EQ(EditDistance("", "abc"), 3U);
}

TEST(KeepFirstTest, CountsTheRest) {
  std::vector<std::string> warnings = {"a", "b", "c"};
  KeepFirst(3, "file", warnings);
  EXPECT_EQ(warnings, (std::vector<std::string>{"a", "b", "c"}));
  KeepFirst(1, "file", warnings);
  EXPECT_EQ(warnings, (std::vector<std::string>{"a", "file: 2 more warnings"}));
}

TEST(ShortenedTest, ShowsBothEndsOfWhatIsLong) {
  EXPECT_EQ(Shortened("0123456789", 10), "0123456789");
  EXPECT_EQ(Shortened("0123456789abc", 10), "01 ... bc");
}

}  // namespace
}  // namespace tilemend
