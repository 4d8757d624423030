#include "worker/texture/base_colours.h"

#include <gtest/gtest.h>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

const RasterFrame kFrame{0.25, -40, 24, 120, 120};

TEST(BaseColoursTest, TheMedianOfASquareIgnoresAFewPixels) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    return x % 2 == 0 && y % 2 == 0 ? Rgb{255, 255, 255} : Rgb{80, 90, 100};
  });
  const SquareLattice squares = MedianSquares(raster, PixelMask(kFrame.size(), 1));
  EXPECT_EQ(squares.values[squares.At(5, 5)], (Channels{80, 90, 100}));
}

TEST(BaseColoursTest, SquaresWithFewSourcesAreNotKnown) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t, int64_t) { return Rgb{80, 90, 100}; });
  const SquareLattice squares = MedianSquares(raster, PixelMask(kFrame.size(), 0));
  for (const float weight : squares.weights) EXPECT_EQ(weight, 0);
}

TEST(BaseColoursTest, ShadowsAreNoSources) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t) {
    return x > 0 && x < 6 ? Rgb{20, 20, 20} : Rgb{100, 100, 100};
  });
  PixelMask sources(kFrame.size(), 1);
  const SquareLattice base = BaseColours(raster, sources).base;
  EXPECT_EQ(sources[kFrame.At(40 + 3, 50)], 0);
  EXPECT_EQ(sources[kFrame.At(10, 50)], 1);
  EXPECT_NEAR(ValueAt(base, kFrame, 43, 50)[0], 100, 1);
}

TEST(BaseColoursTest, TheWholeRasterHasABase) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t, int64_t) { return Rgb{60, 70, 80}; });
  PixelMask sources(kFrame.size(), 0);
  for (int32_t x = 0; x < 20; ++x) {
    for (int32_t y = 0; y < 20; ++y) sources[kFrame.At(x, y)] = 1;
  }
  const SquareLattice base = BaseColours(raster, sources).base;
  EXPECT_NEAR(ValueAt(base, kFrame, 119, 119)[2], 80, 0.5);
}

}  // namespace
}  // namespace tilemend
