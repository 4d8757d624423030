#include "worker/texture/grain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

const RasterFrame kFrame{0.25, -50, 30, 200, 160};

struct Moments {
  double mean = 0, deviation = 0;
};

Moments MomentsOf(const std::vector<Channels>& colours, const PixelMask& make) {
  double count = 0, sum = 0, squares = 0;
  for (size_t i = 0; i < make.size(); ++i) {
    if (make[i] == 0) continue;
    ++count;
    sum += colours[i][1];
    squares += colours[i][1] * colours[i][1];
  }
  return {sum / count, std::sqrt(squares / count - sum / count * (sum / count))};
}

TEST(GrainTest, WhiteGrainHasItsDeviation) {
  double sum = 0, squares = 0;
  constexpr int kSide = 200;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double value = WhiteGrain(x - 77, y + 1000, 1.5);
      sum += value;
      squares += value * value;
    }
  }
  EXPECT_NEAR(sum / (kSide * kSide), 0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / (kSide * kSide)), 1.5, 0.05);
}

TEST(GrainTest, HashesDependOnPlaceAndPurpose) {
  EXPECT_NE(HashOfPlace(1, 2, 3), HashOfPlace(2, 1, 3));
  EXPECT_NE(HashOfPlace(1, 2, 3), HashOfPlace(1, 2, 4));
  EXPECT_NE(HashOfPlace(-1, 2, 3), HashOfPlace(1, 2, 3));
}

TEST(GrainTest, AFillGetsTheGrainOfTheGround) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    const auto grey = static_cast<uint8_t>(90 + HashOfPlace(x, y, 9) % 21);
    return Rgb{grey, grey, grey};
  });
  const std::vector<FillPixel> fill = CutHole(raster, 80, 60, 130, 110, FillPixel::kGround);
  const PixelMask sources = GroundPixels(raster, fill);
  PixelMask make(kFrame.size());
  for (size_t i = 0; i < make.size(); ++i) make[i] = fill[i] == FillPixel::kGround ? 1 : 0;
  std::vector<Channels> colours(kFrame.size(), Channels{100, 100, 100});
  AddGrain(raster, sources, make, colours);
  const Moments made = MomentsOf(colours, make);
  EXPECT_NEAR(made.mean, 100, 1.5);
  EXPECT_NEAR(made.deviation, 6, 1.2);  // of 21 equal steps: 6.06
}

// With few sources the same window came again at every block.
TEST(GrainTest, NothingComesAgain) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    const auto grey = static_cast<uint8_t>(90 + HashOfPlace(x / 3, y / 3, 9) % 21);
    return Rgb{grey, grey, grey};
  });
  PixelMask sources(kFrame.size()), make(kFrame.size());
  for (int32_t y = 10; y < 28; ++y) {
    for (int32_t x = 10; x < 28; ++x) sources[kFrame.At(x, y)] = 1;
  }
  for (int32_t y = 40; y < 150; ++y) {
    for (int32_t x = 40; x < 190; ++x) make[kFrame.At(x, y)] = 1;
  }
  std::vector<Channels> colours(kFrame.size(), Channels{0, 0, 0});
  AddGrain(raster, sources, make, colours);
  for (int32_t shift = 10; shift < 32; ++shift) {
    double product = 0, squares = 0;
    for (int32_t y = 40; y < 150; ++y) {
      for (int32_t x = 40; x + shift < 190; ++x) {
        const double here = colours[kFrame.At(x, y)][1];
        product += here * colours[kFrame.At(x + shift, y)][1];
        squares += here * here;
      }
    }
    EXPECT_LT(std::abs(product), 0.15 * squares) << "after " << shift << " pixels";
  }
}

// A tile with an image west of the hole; the one east of it has one colour.
TEST(GrainTest, APlainNeighbourTakesNoGrainAway) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    const auto grey = static_cast<uint8_t>(90 + (x < 50 ? HashOfPlace(x, y, 9) % 21 : 10));
    return Rgb{grey, grey, grey};
  });
  for (int32_t y = 0; y < kFrame.height; ++y) {
    for (int32_t x = 100; x < kFrame.width; ++x) raster.known[kFrame.At(x, y)] = kPlainColour;
  }
  const std::vector<FillPixel> fill = CutHole(raster, 75, 60, 125, 110, FillPixel::kGround);
  const PixelMask sources = GroundPixels(raster, fill);
  PixelMask make(kFrame.size());
  for (size_t i = 0; i < make.size(); ++i) make[i] = fill[i] == FillPixel::kGround ? 1 : 0;
  std::vector<Channels> colours(kFrame.size(), Channels{100, 100, 100});
  AddGrain(raster, sources, make, colours);
  EXPECT_NEAR(MomentsOf(colours, make).deviation, 6, 1.2);
}

TEST(GrainTest, PlainGroundHasNoGrain) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t, int64_t) { return Rgb{90, 90, 90}; });
  raster.known.assign(kFrame.size(), kPlainColour);
  const PixelMask all(kFrame.size(), 1);
  std::vector<Channels> colours(kFrame.size(), Channels{100, 100, 100});
  AddGrain(raster, all, all, colours);
  EXPECT_EQ(MomentsOf(colours, all).deviation, 0);
}

TEST(GrainTest, NoGrainHoldsAMark) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    const bool is_mark = x > 60 && x < 70 && y > 60 && y < 70;
    const auto grey = static_cast<uint8_t>(is_mark ? 250 : 90 + HashOfPlace(x, y, 9) % 5);
    return Rgb{grey, grey, grey};
  });
  const std::vector<FillPixel> fill = CutHole(raster, 20, 60, 70, 110, FillPixel::kGround);
  const PixelMask sources = GroundPixels(raster, fill);
  PixelMask make(kFrame.size());
  for (size_t i = 0; i < make.size(); ++i) make[i] = fill[i] == FillPixel::kGround ? 1 : 0;
  std::vector<Channels> colours(kFrame.size(), Channels{100, 100, 100});
  AddGrain(raster, sources, make, colours);
  for (size_t i = 0; i < make.size(); ++i) EXPECT_NEAR(colours[i][0], 100, 6);
}

}  // namespace
}  // namespace tilemend
