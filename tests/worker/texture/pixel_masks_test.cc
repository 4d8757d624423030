#include "worker/texture/pixel_masks.h"

#include <gtest/gtest.h>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

const RasterFrame kFrame{0.25, 0, 0, 200, 160};

OrthoRaster Grey() {
  return RasterOf(kFrame, [](int64_t, int64_t) { return Rgb{90, 90, 90}; });
}

TEST(PixelMasksTest, DilationIsASquare) {
  const RasterFrame frame{1, 0, 0, 9, 7};
  PixelMask mask(frame.size());
  mask[frame.At(4, 0)] = 1;
  const PixelMask grown = Dilated(mask, frame, 2);
  for (int32_t y = 0; y < 7; ++y) {
    for (int32_t x = 0; x < 9; ++x)
      EXPECT_EQ(grown[frame.At(x, y)], x >= 2 && x <= 6 && y <= 2 ? 1 : 0) << x << ' ' << y;
  }
}

TEST(PixelMasksTest, SmallRegionsGo) {
  const RasterFrame frame{1, 0, 0, 6, 3};
  PixelMask mask = {1, 1, 0, 0, 0, 1,  //
                    0, 1, 0, 0, 1, 0,  //
                    1, 0, 0, 1, 1, 1};
  DropSmallRegions(frame, 3, mask);
  EXPECT_EQ(mask, (PixelMask{1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 1, 1}));
}

TEST(PixelMasksTest, AHouseIsNoGroundAndNeitherIsItsSurroundings) {
  OrthoRaster raster = Grey();
  for (int32_t y = 60; y < 90; ++y) {
    for (int32_t x = 80; x < 120; ++x) raster.heights[kFrame.At(x, y)] = 6;
  }
  const PixelMask ground = GroundPixels(raster, std::vector<FillPixel>(kFrame.size(), FillPixel::kNone));
  EXPECT_EQ(ground[kFrame.At(100, 75)], 0);
  EXPECT_EQ(ground[kFrame.At(79, 75)], 0);
  EXPECT_EQ(ground[kFrame.At(70, 75)], 1);
}

TEST(PixelMasksTest, ASlopeIsGround) {
  OrthoRaster raster = Grey();
  for (int32_t y = 0; y < kFrame.height; ++y) {
    for (int32_t x = 0; x < kFrame.width; ++x) raster.heights[kFrame.At(x, y)] = static_cast<float>(0.02 * x);
  }
  const PixelMask ground = GroundPixels(raster, std::vector<FillPixel>(kFrame.size(), FillPixel::kNone));
  EXPECT_EQ(ground[kFrame.At(100, 75)], 1);
}

TEST(PixelMasksTest, TheFillIsKeptAwayFrom) {
  OrthoRaster raster = Grey();
  const std::vector<FillPixel> fill = CutHole(raster, 80, 60, 120, 100, FillPixel::kGround);
  const PixelMask ground = GroundPixels(raster, fill);
  EXPECT_EQ(ground[kFrame.At(90, 70)], 0);
  EXPECT_EQ(ground[kFrame.At(78, 70)], 0);
  EXPECT_EQ(ground[kFrame.At(76, 70)], 1);
}

TEST(PixelMasksTest, WaterLiesWithinItsBand) {
  OrthoRaster raster = Grey();
  for (int32_t y = 0; y < 40; ++y) {
    for (int32_t x = 0; x < kFrame.width; ++x) raster.heights[kFrame.At(x, y)] = 1;
  }
  const std::vector<FillPixel> fill = CutHole(raster, 80, 60, 120, 100, FillPixel::kWater);
  const PixelMask water = WaterPixels(raster, fill, 0.1);
  EXPECT_EQ(water[kFrame.At(10, 50)], 1);
  EXPECT_EQ(water[kFrame.At(10, 20)], 0);
  EXPECT_EQ(water[kFrame.At(79, 70)], 0);
  EXPECT_EQ(water[kFrame.At(78, 70)], 1);
}

}  // namespace
}  // namespace tilemend
