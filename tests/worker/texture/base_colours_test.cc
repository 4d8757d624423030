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
  DropShadows(raster, sources);
  EXPECT_EQ(sources[kFrame.At(40 + 3, 50)], 0);
  EXPECT_EQ(sources[kFrame.At(10, 50)], 1);
}

TEST(BaseColoursTest, TheMiddleIsThatOfMostSquares) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t) {
    return x < 40 ? Rgb{60, 70, 80} : Rgb{250, 10, 10};  // three parts of five
  });
  SquareLattice squares = MedianSquares(raster, PixelMask(kFrame.size(), 1));
  const Channels middle = MiddleOf(squares);
  EXPECT_NEAR(middle[0], 60, 2);
  EXPECT_NEAR(middle[2], 80, 2);
}

}  // namespace
}  // namespace tilemend
