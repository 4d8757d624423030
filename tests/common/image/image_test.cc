#include "common/image/image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/image_builders.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

// Four quarters: red and green above, blue and white below.
Rgb Quarters(int32_t column, int32_t row, int32_t side) {
  const bool right = column >= side / 2, below = row >= side / 2;
  if (below) return right ? Rgb{250, 250, 250} : Rgb{20, 30, 220};
  return right ? Rgb{10, 200, 40} : Rgb{210, 20, 10};
}
PixelColour QuartersOf(int32_t side) {
  return [side](int32_t column, int32_t row) { return Quarters(column, row, side); };
}

void ExpectNear(Rgb found, Rgb expected, int tolerance) {
  EXPECT_LE(std::abs(found.r - expected.r), tolerance);
  EXPECT_LE(std::abs(found.g - expected.g), tolerance);
  EXPECT_LE(std::abs(found.b - expected.b), tolerance);
}

void ExpectQuarters(const Image& image, int tolerance) {
  ExpectNear(TexelAt(image, 0.25, 0.75), {210, 20, 10}, tolerance);
  ExpectNear(TexelAt(image, 0.75, 0.75), {10, 200, 40}, tolerance);
  ExpectNear(TexelAt(image, 0.25, 0.25), {20, 30, 220}, tolerance);
  ExpectNear(TexelAt(image, 0.75, 0.25), {250, 250, 250}, tolerance);
}

TEST(DecodeImageTest, ReadsPngExactly) {
  const auto image = DecodeImage(PngImage(16, 16, QuartersOf(16)), "a.png");
  ASSERT_TRUE(image.ok()) << image.status();
  EXPECT_EQ(image->width, 16);
  ExpectQuarters(*image, 0);
}

// libpng takes 16 bits a sample for linear light where the image does not say what they are.
TEST(DecodeImageTest, ReadsPngOf16BitsAsIfOf8) {
  const auto image = DecodeImage(WidePngImage(16, 16, QuartersOf(16)), "a.png");
  ASSERT_TRUE(image.ok()) << image.status();
  ExpectQuarters(*image, 1);
}

TEST(DecodeImageTest, ReadsSequentialAndProgressiveJpeg) {
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    const auto image = DecodeImage(JpegImage(64, 64, QuartersOf(64), flags), "a.jpg");
    ASSERT_TRUE(image.ok()) << image.status();
    EXPECT_EQ(image->width, 64);
    ExpectQuarters(*image, 3);
  }
}

TEST(DecodeImageTest, MixesInks) {
  const auto image = DecodeImage(InkJpegImage(64, 64, QuartersOf(64), 255), "a.jpg");
  ASSERT_TRUE(image.ok()) << image.status();
  EXPECT_EQ(image->width, 64);
  ExpectQuarters(*image, 3);
  const auto dark = DecodeImage(InkJpegImage(64, 64, QuartersOf(64), 128), "a.jpg");
  ASSERT_TRUE(dark.ok()) << dark.status();
  ExpectNear(TexelAt(*dark, 0.75, 0.25), {125, 125, 125}, 3);
}

TEST(DecodeImageTest, DecodesLargeJpegsAtAPartOfTheirSize) {
  constexpr int32_t kSide = 2 * kFullSide;
  const auto image = DecodeImage(JpegImage(kSide, 512, QuartersOf(kSide)), "a.jpg");
  ASSERT_TRUE(image.ok()) << image.status();
  EXPECT_EQ(image->width, kFullSide);
  EXPECT_EQ(image->height, 256);
  ExpectNear(TexelAt(*image, 0.2, 0.5), {210, 20, 10}, 3);
}

TEST(DecodeImageTest, DecodesLargeJpegsOfOneScanAtTheirSizeIfAsked) {
  constexpr int32_t kSide = 2 * kFullSide;
  const auto width = [](int flags) {
    const auto image = DecodeImage(JpegImage(kSide, 16, QuartersOf(kSide), flags), "a.jpg", JpegSize::kLarge);
    return image.ok() ? image->width : 0;
  };
  EXPECT_EQ(width(0), kSide);
  EXPECT_EQ(width(TJFLAG_PROGRESSIVE), kFullSide) << "the decoder holds all its coefficients";
}

TEST(DecodeImageTest, RefusesWhatIsNoImage) {
  EXPECT_THAT(DecodeImage("", "a.jpg").status().message(), HasSubstr("a.jpg: an empty file"));
  EXPECT_THAT(DecodeImage("BM, a bitmap", "a.bmp").status().message(), HasSubstr("neither a JPEG nor a PNG"));
  EXPECT_FALSE(DecodeImage("\xff\xd8", "a.jpg").ok());
  EXPECT_FALSE(DecodeImage("\x89PNG\r\n\x1a\n", "a.png").ok());
}

TEST(DecodeImageTest, RefusesImagesThatAreCutOff) {
  for (const std::string& whole : {JpegImage(64, 64, QuartersOf(64)), PngImage(64, 64, QuartersOf(64)),
                                   JpegImage(64, 64, QuartersOf(64), TJFLAG_PROGRESSIVE)}) {
    for (size_t length = 0; length + 16 < whole.size(); length += 7) {
      EXPECT_FALSE(DecodeImage(whole.substr(0, length), "cut").ok()) << length << " of " << whole.size();
    }
  }
}

TEST(DecodeImageTest, ReadsJpegsWithBytesBetweenTheirMarkers) {
  const std::string whole = JpegImage(64, 64, QuartersOf(64));
  for (const std::string& marker : {std::string("\xff\xc0"), std::string("\xff\xd9")}) {
    std::string bytes = whole;
    bytes.insert(bytes.rfind(marker), "some text");
    const auto image = DecodeImage(bytes, "a.jpg");
    ASSERT_TRUE(image.ok()) << image.status();
    ExpectQuarters(*image, 3);
    bytes.resize(bytes.size() - 40);
    EXPECT_FALSE(DecodeImage(bytes, "a.jpg").ok()) << "cut off as well";
  }
}

TEST(DecodeImageTest, RefusesAJpegWhoseScanEndsEarly) {
  std::string bytes = JpegImage(64, 64, [](int32_t x, int32_t y) { return Rgb{static_cast<uint8_t>(x * y), 0, 0}; });
  bytes.erase(bytes.size() - 100, 98);  // before the marker of the end
  EXPECT_THAT(DecodeImage(bytes, "a.jpg").status().message(), HasSubstr("damaged"));
}

TEST(DecodeImageTest, EndsOnAnyDamage) {
  for (const std::string& whole : {JpegImage(32, 32, QuartersOf(32)), PngImage(32, 32, QuartersOf(32)),
                                   JpegImage(32, 32, QuartersOf(32), TJFLAG_PROGRESSIVE)}) {
    for (size_t at = 0; at < whole.size(); ++at) {
      for (const char bits : {'\x01', '\x80', '\xff'}) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ bits);
        const auto image = DecodeImage(damaged, "damaged");
        EXPECT_TRUE(!image.ok() || !image->pixels.empty());
      }
    }
  }
}

// The frame header says 65,500 x 65,500 pixels, in a file of a few hundred bytes.
TEST(DecodeImageTest, RefusesMorePixelsThanTheFileCanHold) {
  for (const int flags : {0, TJFLAG_PROGRESSIVE}) {
    std::string bytes = JpegImage(16, 16, QuartersOf(16), flags);
    const size_t frame = bytes.find(flags == 0 ? "\xff\xc0" : "\xff\xc2");
    ASSERT_NE(frame, std::string::npos);
    bytes.replace(frame + 5, 4, "\xff\xdc\xff\xdc");
    EXPECT_THAT(DecodeImage(bytes, "bomb").status().message(), HasSubstr("too large"));
    bytes.replace(frame + 5, 4, "\x10\x10\x10\x10");
    EXPECT_THAT(DecodeImage(bytes, "bomb").status().message(), HasSubstr("does not fit"));
  }
}

TEST(TexelAtTest, RepeatsTheImageOutsideTheUnitSquare) {
  const Image image{2, 1, 3, {1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(TexelAt(image, 0.25, 0.5), (Rgb{1, 2, 3}));
  EXPECT_EQ(TexelAt(image, 1.25, -0.5), (Rgb{1, 2, 3}));
  EXPECT_EQ(TexelAt(image, -0.25, 7.5), (Rgb{4, 5, 6}));
  EXPECT_EQ(TexelAt(image, 1, 1), (Rgb{1, 2, 3}));
}

TEST(TexelAtTest, RowsCountFromTheTopAndVFromTheBottom) {
  const Image image{1, 2, 3, {1, 1, 1, 9, 9, 9}};
  EXPECT_EQ(TexelAt(image, 0, 0.1), (Rgb{9, 9, 9}));
  EXPECT_EQ(TexelAt(image, 0, 0.9), (Rgb{1, 1, 1}));
}

TEST(EncodeJpegTest, IsReadBack) {
  Image image{9, 5, 3, {}};
  for (int i = 0; i < 9 * 5; ++i) image.pixels.insert(image.pixels.end(), {40, 200, static_cast<uint8_t>(3 * i)});
  const auto bytes = EncodeJpeg(image, 95);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_EQ(EncodeJpeg(image, 95).value(), *bytes);
  const auto read = DecodeImage(*bytes, "a.jpg");
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(read->width, 9);
  EXPECT_NEAR(TexelAt(*read, 0.5, 0.5).g, 200, 6);
  EXPECT_NEAR(TexelAt(*read, 0.5, 0.5).b, 66, 8);
}

}  // namespace
}  // namespace tilemend
