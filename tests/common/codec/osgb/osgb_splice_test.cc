#include "common/codec/osgb/osgb_splice.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

// "[" is a size of `size_bytes` bytes with that value.
std::string Bracketed(size_t size_bytes, char outer, const std::string& before, char inner, const std::string& text) {
  const std::string zeros(size_bytes - 1, '\0');
  return "x" + (outer + zeros) + before + (inner + zeros) + text;
}

OsgbLayout LayoutWith(size_t size_bytes) {
  OsgbLayout layout;
  layout.bracket_bytes = size_bytes;
  layout.brackets = {{1, -1}, {1 + size_bytes + 2, 0}};
  return layout;
}

TEST(OsgbSpliceTest, WithoutEditsTheBytesAreTheSame) {
  const OsgbLayout layout;
  EXPECT_EQ(*OsgbSplice("some bytes", layout).Finish("a"), "some bytes");
}

TEST(OsgbSpliceTest, InsertionsGrowAllEnclosingBrackets) {
  for (const size_t size_bytes : {size_t{4}, size_t{8}}) {
    const auto outer = static_cast<char>(2 * size_bytes + 5);
    const auto inner = static_cast<char>(size_bytes + 3);
    const std::string bytes = Bracketed(size_bytes, outer, "ab", inner, "cde");
    const OsgbLayout layout = LayoutWith(size_bytes);
    OsgbSplice splice(bytes, layout);
    splice.Replace(1 + size_bytes, 0, "12", 0);
    splice.Replace(bytes.size(), 0, "345", 1);
    EXPECT_EQ(*std::move(splice).Finish("a"),
              Bracketed(size_bytes, static_cast<char>(outer + 5), "12ab", static_cast<char>(inner + 3), "cde345"));
  }
}

TEST(OsgbSpliceTest, RemovalsShrinkThemAndNumbersAreOverwritten) {
  const std::string bytes = Bracketed(4, 13, "ab", 7, "cde");
  const OsgbLayout layout = LayoutWith(4);
  OsgbSplice splice(bytes, layout);
  splice.Replace(12, 2, "", 1);
  EXPECT_EQ(*std::move(splice).Finish("a"), Bracketed(4, 11, "ab", 5, "c"));
  const OsgbLayout plain;
  OsgbSplice numbers("0123456789", plain);
  numbers.SetNumber(3, 0x64636261);
  EXPECT_EQ(*std::move(numbers).Finish("a"), "012abcd789");
}

TEST(OsgbSpliceTest, SeveralInsertionsAtOnePlaceStayInOrder) {
  const OsgbLayout layout;
  OsgbSplice splice("ab", layout);
  splice.Replace(1, 0, "1", -1);
  splice.Replace(1, 0, "2", -1);
  EXPECT_EQ(*std::move(splice).Finish("a"), "a12b");
}

}  // namespace
}  // namespace tilemend
