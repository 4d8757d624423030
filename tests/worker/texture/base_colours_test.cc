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

// Ground that goes from dark to light over 200 m, as two cells beside each other see it.
Channels MiddleAt(const RasterFrame& frame, int32_t column, int32_t row) {
  const OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t) {
    const auto grey = static_cast<uint8_t>(x + 100);
    return Rgb{grey, grey, grey};
  });
  const PixelMask all(frame.size(), 1);
  const SquareLattice middles = MiddlesNear(frame, MedianSquares(raster, all), all);
  return ValueAt(middles, frame, static_cast<int32_t>(column - frame.column), static_cast<int32_t>(row - frame.row));
}

TEST(BaseColoursTest, TwoRastersGiveAPlaceTheSameMiddle) {
  const RasterFrame west{1, -100, 0, 148, 20}, east{1, -48, 0, 148, 20};  // both know 48 m beside column 0
  EXPECT_NEAR(MiddleAt(west, 0, 10)[0], MiddleAt(east, 0, 10)[0], 0.1);
  EXPECT_NEAR(MiddleAt(west, 0, 10)[0], 100, 1);
  EXPECT_NEAR(MiddleAt(west, -50, 10)[0], 50, 1);
}

TEST(BaseColoursTest, FarFromAllThatIsKnownTheMiddleIsThatOfAll) {
  const RasterFrame frame{1, 0, 0, 200, 8};
  const OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t) {
    return x < 40 ? Rgb{60, 60, 60} : Rgb{200, 200, 200};
  });
  PixelMask sources(frame.size());
  for (int32_t y = 0; y < frame.height; ++y) {
    for (int32_t x = 0; x < frame.width; ++x) sources[frame.At(x, y)] = x < 12 || x >= 196 ? 1 : 0;
  }
  const SquareLattice middles = MiddlesNear(frame, MedianSquares(raster, sources), PixelMask(frame.size(), 1));
  EXPECT_NEAR(ValueAt(middles, frame, 0, 4)[0], 60, 1);
  EXPECT_NEAR(ValueAt(middles, frame, 100, 4)[0], 60, 1);
  EXPECT_NEAR(ValueAt(middles, frame, 199, 4)[0], 200, 6);
}

}  // namespace
}  // namespace tilemend
