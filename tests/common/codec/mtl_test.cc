#include "common/codec/mtl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_join.h"

namespace tilemend {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ParseMtlTest, ReadsMaterialsColoursAndImages) {
  const MtlFile file = ParseMtl(
      "# c\r\nnewmtl wall red \r\n\tKd 1 0.5 0\r\nmap_Kd Tile 0.jpg\r\nmap_Ka Tile 0.jpg\nnewmtl roof\nkd 2 -1 x\nKD 0 "
      "0 1\n"
      "MAP_KD sub\\roof.png\rbump roof_n.png");
  ASSERT_EQ(file.materials.size(), 2U);
  EXPECT_EQ(file.materials[0].name, "wall red");
  EXPECT_EQ(file.materials[0].diffuse, (Rgb{255, 128, 0}));
  EXPECT_EQ(file.materials[0].image, "Tile 0.jpg");
  EXPECT_EQ(file.materials[1].diffuse, (Rgb{0, 0, 255}));
  EXPECT_EQ(file.materials[1].image, "sub\\roof.png");
  EXPECT_THAT(file.images, ElementsAre("Tile 0.jpg", "sub\\roof.png", "roof_n.png"));
}

TEST(ParseMtlTest, SaysInWhichLineAnImageIsNamedFirst) {
  for (const char* eol : {"\n", "\r\n", "\r"}) {
    const MtlFile file = ParseMtl(absl::StrJoin({"newmtl a", "", "map_Kd a.jpg", "bump b.jpg", "disp a.jpg"}, eol));
    EXPECT_THAT(file.images, ElementsAre("a.jpg", "b.jpg"));
    EXPECT_THAT(file.image_lines, ElementsAre(3, 4));
  }
}

TEST(ParseMtlTest, OptionsAreNoPartOfAName) {
  const MtlFile file = ParseMtl(
      "newmtl a\nmap_Kd -s 1 1 1 -o 0.5 -clamp on a b.jpg\nmap_Bump -bm 0.2 n.png\nmap_Ks -mm 0 1 2 k.png\n"
      "refl -type sphere s.png\nmap_d -x\nmap_aat on\nmap_Ns -t 7\ndisp\n");
  EXPECT_THAT(file.images, ElementsAre("a b.jpg", "n.png", "2 k.png", "s.png", "-x", "-t 7"));
  EXPECT_EQ(file.materials[0].image, "a b.jpg");
}

TEST(ParseMtlTest, AnyTextIsRead) {
  EXPECT_THAT(ParseMtl("").materials, IsEmpty());
  EXPECT_THAT(ParseMtl("map_Kd lost.jpg\nKd 1 1 1\nnewmtl\n").images, ElementsAre("lost.jpg"));
  EXPECT_EQ(ParseMtl("\xef\xbb\xbfnewmtl a\nKd nan 1 1").materials[0].diffuse, std::nullopt);
  EXPECT_THAT(ParseMtl(std::string("\0\xff newmtl\nx", 11)).materials, IsEmpty());
}

TEST(AppendToMtlTest, KeepsTheTextAndDefinesTheMaterials) {
  EXPECT_EQ(
      AppendToMtl("newmtl a\r\nKd 1 1 1", {{"fill_1", {255, 0, 51}}}),
      "newmtl a\r\nKd 1 1 1\r\nnewmtl fill_1\r\nKa 1.000000 0.000000 0.200000\r\nKd 1.000000 0.000000 0.200000\r\n"
      "Ks 0 0 0\r\nd 1\r\nillum 1\r\n");
}

TEST(AppendToMtlTest, DefinesEachNameOnce) {
  const std::string text = "newmtl a\n";
  EXPECT_EQ(AppendToMtl(text, {{"a", {1, 2, 3}}}), text);
  const std::string once = AppendToMtl("", {{"b", {1, 2, 3}}});
  EXPECT_EQ(AppendToMtl("", {{"b", {1, 2, 3}}, {"b", {1, 2, 3}}}), once);
  EXPECT_EQ(ParseMtl(once).materials.size(), 1U);
  EXPECT_EQ(ParseMtl(once).materials[0].diffuse, (Rgb{1, 2, 3}));
}

TEST(AppendToMtlTest, NamesTheImageOfAMaterial) {
  const MtlFile file = ParseMtl(AppendToMtl("", {{"b", {255, 255, 255}, "a b.jpg"}}));
  EXPECT_EQ(file.materials[0].image, "a b.jpg");
}

}  // namespace
}  // namespace tilemend
