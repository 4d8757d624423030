#include "worker/texture/streamlines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

const RasterFrame kFrame{0.25, 0, 0, 240, 200};

// A road with white lines along x, every 4 m.
Rgb Road(int64_t, int64_t row) { return row % 16 < 2 ? Rgb{200, 200, 200} : Rgb{80, 80, 80}; }

TEST(StreamlinesTest, LinesGoOnThroughAHole) {
  OrthoRaster raster = RasterOf(kFrame, Road);
  const std::vector<FillPixel> fill = CutHole(raster, 90, 70, 150, 130, FillPixel::kGround);
  const PixelMask sources = GroundPixels(raster, fill);
  PixelMask make(kFrame.size());
  for (size_t i = 0; i < make.size(); ++i) make[i] = fill[i] == FillPixel::kGround ? 1 : 0;
  std::vector<Channels> colours(kFrame.size(), Channels{90, 90, 90});
  CarryStructure(raster, sources, StructureOf(raster, sources), make, colours);
  for (const int32_t y : {72, 80, 81, 90, 96, 100, 113, 120}) {
    EXPECT_NEAR(colours[kFrame.At(120, y)][0], Road(0, y).r, 4) << y;
  }
}

TEST(StreamlinesTest, GroundWithoutADirectionKeepsTheBase) {
  OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) {
    return (x / 8 + y / 8) % 2 == 0 ? Rgb{80, 80, 80} : Rgb{120, 120, 120};
  });
  const std::vector<FillPixel> fill = CutHole(raster, 90, 70, 150, 130, FillPixel::kGround);
  const PixelMask sources = GroundPixels(raster, fill);
  std::vector<Channels> colours(kFrame.size(), Channels{90, 90, 90});
  CarryStructure(raster, sources, StructureOf(raster, sources), PixelMask(kFrame.size(), 1), colours);
  for (const Channels& c : colours) EXPECT_EQ(c[0], 90);
}

TEST(StreamlinesTest, TheFieldLiesAlongLines) {
  const OrthoRaster raster = RasterOf(kFrame, [](int64_t x, int64_t y) { return Road(0, x + y); });
  const StructureField field = StructureOf(raster, PixelMask(kFrame.size(), 1));
  const Channels& middle = field.squares.values[SquareOf(field.squares, kFrame, 120, 100)];
  EXPECT_NEAR(std::abs(middle[0] - middle[1]), std::sqrt(2.0), 0.02);
  EXPECT_GT(middle[2], 0.9);
}

}  // namespace
}  // namespace tilemend
