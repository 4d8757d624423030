#include "worker/texture/synthesize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/worker/texture/raster_builders.h"
#include "worker/texture/grain.h"

namespace tilemend {
namespace {

Rgb Asphalt(int64_t x, int64_t y) {
  const auto grey = static_cast<uint8_t>(90 + HashOfPlace(x, y, 1) % 9 + (y % 20 < 2 ? 100 : 0));
  return {grey, grey, grey};
}

double MeanDifference(const std::vector<Rgb>& colours, const OrthoRaster& truth, const std::vector<FillPixel>& fill) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < fill.size(); ++i) {
    if (fill[i] == FillPixel::kNone) continue;
    sum += std::abs(int{colours[i].g} - int{truth.colours[i].g});
    ++count;
  }
  return sum / count;
}

TEST(SynthesizeTest, ARoadGoesOnAndTheRestStays) {
  const RasterFrame frame{0.25, 11, -7, 240, 200};
  const OrthoRaster truth = RasterOf(frame, Asphalt);
  OrthoRaster raster = truth;
  const std::vector<FillPixel> fill = CutHole(raster, 90, 70, 150, 130, FillPixel::kGround);
  const std::vector<Rgb> made = Synthesize(raster, MapOf(fill), {});
  EXPECT_LT(MeanDifference(made, truth, fill), 8);
  for (size_t i = 0; i < fill.size(); ++i) {
    if (fill[i] == FillPixel::kNone) {
      EXPECT_EQ(made[i], truth.colours[i]);
    }
  }
}

TEST(SynthesizeTest, EqualInputGivesEqualColours) {
  const RasterFrame frame{0.25, 0, 0, 160, 160};
  OrthoRaster raster = RasterOf(frame, Asphalt);
  const std::vector<FillPixel> fill = CutHole(raster, 60, 60, 100, 100, FillPixel::kGround);
  EXPECT_EQ(Synthesize(raster, MapOf(fill), {}), Synthesize(raster, MapOf(fill), {}));
}

TEST(SynthesizeTest, APartOfTheHoleIsMadeAsTheWholeIs) {
  const RasterFrame frame{0.25, 0, 0, 160, 160};
  OrthoRaster raster = RasterOf(frame, Asphalt);
  const std::vector<FillPixel> whole = CutHole(raster, 60, 60, 100, 100, FillPixel::kGround);
  std::vector<FillPixel> left = whole;
  for (int32_t y = 60; y < 100; ++y) {
    for (int32_t x = 60; x < 100; ++x)
      if (x >= 80) left[frame.At(x, y)] = FillPixel::kForeign;
  }
  const std::vector<Rgb> of_whole = Synthesize(raster, MapOf(whole), {}), of_left = Synthesize(raster, MapOf(left), {});
  int differing = 0;
  for (size_t i = 0; i < left.size(); ++i) {
    if (left[i] == FillPixel::kGround) differing += of_whole[i] == of_left[i] ? 0 : 1;
  }
  EXPECT_LT(differing, 400);  // of 800; blocks of grain beyond the part are not laid
}

TEST(SynthesizeTest, WaterHasTheColourOfItsBodyAndNoneOfItsBank) {
  const RasterFrame frame{0.25, 0, 0, 200, 200};
  OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t) {
    return x < 100 ? Rgb{40, 60, 50} : Rgb{200, 180, 160};
  });
  for (int32_t y = 0; y < 200; ++y) {
    for (int32_t x = 100; x < 200; ++x) raster.heights[frame.At(x, y)] = 2;
  }
  const std::vector<FillPixel> fill = CutHole(raster, 60, 60, 100, 140, FillPixel::kWater);
  FillLook look;
  look.water = {44, 60, 50};
  const std::vector<Rgb> made = Synthesize(raster, MapOf(fill), look);
  for (size_t i = 0; i < fill.size(); ++i) {
    if (fill[i] == FillPixel::kWater) {
      EXPECT_NEAR(made[i].r, 42, 9);
    }
  }
  EXPECT_NEAR(made[frame.At(80, 100)].r, 44, 6) << "5 m from the rim";
}

// Noisy water has pits everywhere, and so is higher than an opening of 20 m; a street beside it is as high as it is.
TEST(SynthesizeTest, AFillHasTheColourOfTheSurfaceThatItGoesOnFrom) {
  const RasterFrame frame{0.25, 0, 0, 240, 240};
  OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t y) {
    const bool is_pond = x >= 40 && x < 200 && y >= 40 && y < 200;
    return is_pond ? Rgb{40, 60, 50} : Rgb{200, 180, 160};
  });
  for (int32_t y = 44; y < 200; y += 16) {
    for (int32_t x = 44; x < 200; x += 16) raster.heights[frame.At(x, y)] = -2;
  }
  const std::vector<FillPixel> fill = CutHole(raster, 90, 90, 150, 150, FillPixel::kGround);
  const std::vector<Rgb> made = Synthesize(raster, MapOf(fill), {});
  for (size_t i = 0; i < fill.size(); ++i) {
    if (fill[i] == FillPixel::kGround) {
      EXPECT_NEAR(made[i].r, 40, 12);
    }
  }
}

// One patch of another colour at the rim does not colour half of the fill.
TEST(SynthesizeTest, APatchAtTheRimFades) {
  const RasterFrame frame{0.25, 0, 0, 240, 240};
  OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t y) {
    return x >= 60 && x < 80 && y >= 110 && y < 130 ? Rgb{60, 60, 110} : Rgb{90, 90, 90};
  });
  const std::vector<FillPixel> fill = CutHole(raster, 80, 80, 160, 160, FillPixel::kGround);
  const std::vector<Rgb> made = Synthesize(raster, MapOf(fill), {});
  EXPECT_LT(made[frame.At(82, 120)].r, 75) << "beside the patch";
  EXPECT_NEAR(made[frame.At(100, 120)].r, 90, 4) << "5 m away";
}

TEST(SynthesizeTest, GivenWaterHasItsColourUpToGrain) {
  const RasterFrame frame{0.25, 0, 0, 100, 100};
  OrthoRaster raster = RasterOf(frame, Asphalt);
  const std::vector<FillPixel> fill = CutHole(raster, 30, 30, 70, 70, FillPixel::kWater);
  FillLook look;
  look.given_water = Rgb{10, 100, 200};
  const std::vector<Rgb> made = Synthesize(raster, MapOf(fill), look);
  EXPECT_NEAR(made[frame.At(50, 50)].g, 100, 8);
  EXPECT_NEAR(made[frame.At(31, 31)].b, 200, 8);
}

TEST(SynthesizeTest, WithoutASourceTheFlatColourStays) {
  const RasterFrame frame{0.25, 0, 0, 40, 40};
  OrthoRaster raster(frame);
  FillLook look;
  look.ground = {1, 2, 3};
  const std::vector<Rgb> made =
      Synthesize(raster, MapOf(std::vector<FillPixel>(frame.size(), FillPixel::kGround)), look);
  for (const Rgb c : made) EXPECT_EQ(c, (Rgb{1, 2, 3}));
}

TEST(SynthesizeTest, PixelsOfAnotherCellsHoleHaveTheColourBeside) {
  const RasterFrame frame{0.25, 0, 0, 96, 96};
  OrthoRaster raster = RasterOf(frame, [](int64_t, int64_t) { return Rgb{90, 120, 40}; });
  std::vector<FillPixel> pixels = CutHole(raster, 40, 40, 60, 60, FillPixel::kGround);
  for (int32_t y = 40; y < 60; ++y) {
    for (int32_t x = 50; x < 60; ++x) pixels[frame.At(x, y)] = FillPixel::kForeign;
  }
  for (const Rgb c : Synthesize(raster, MapOf(pixels), {})) {
    EXPECT_NEAR(c.r, 90, 12);
    EXPECT_NEAR(c.g, 120, 12);
    EXPECT_NEAR(c.b, 40, 12);
  }
}

}  // namespace
}  // namespace tilemend
