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

}  // namespace
}  // namespace tilemend
