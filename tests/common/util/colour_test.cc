#include "common/util/colour.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(ColourTest, ReadsNumbersAndHexadecimal) {
  EXPECT_EQ(ParseColour("10,20,255"), (Rgb{10, 20, 255}));
  EXPECT_EQ(ParseColour("#0a14FF"), (Rgb{10, 20, 255}));
  EXPECT_EQ(ParseColour("10, 20,  255"), (Rgb{10, 20, 255}));
}

TEST(ColourTest, RefusesAnythingElse) {
  for (const char* text : {"", "#", "#12345", "#1234567", "#12345g", "1,2", "1,2,3,4", "1,2,256", "1,2,-3", "1 ,2,3",
                           " 1,2,3", "1,2,3 ", "1, ,3", "1,2, ", "blue", ",,", "1,,3", "+1,2,3", "#+1+2+3"}) {
    EXPECT_EQ(ParseColour(text), std::nullopt) << text;
  }
}

TEST(ColourTest, TextReadsBackAsTheColour) {
  EXPECT_EQ(ColourText({1, 2, 254}), "#0102fe");
  EXPECT_EQ(ParseColour(ColourText({1, 2, 254})), (Rgb{1, 2, 254}));
}

}  // namespace
}  // namespace tilemend
