#include "worker/propose/water_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tilemend {
namespace {

using ::testing::SizeIs;

// A canal between two quays, with a house and trees beside it.
GroundRaster Canal(int32_t col, int32_t cols) {
  GroundRaster raster = EmptyRaster(1, col, 0, cols, 80);
  for (int32_t row = 0; row < 80; ++row) {
    for (int32_t c = col; c < col + cols; ++c) {
      const bool house = row > 55 && row < 65 && c > 40 && c<60, trees = row> 20 && row < 30 && c % 5 < 3;
      const float height = std::abs(row - 40) < 8 ? 1.F : house ? 12.F : trees ? 9.F : 3.F;
      raster.heights[raster.IndexOf(c, row)] = height;
    }
  }
  return raster;
}

TEST(FindWaterSurfacesTest, ACanalIsFoundHoweverTheSceneIsCut) {
  const std::vector<LowRegion> whole = FindWaterSurfaces(std::vector<GroundRaster>{Canal(0, 100)});
  ASSERT_THAT(whole, SizeIs(1));
  EXPECT_NEAR(whole[0].level, 1, 1e-6);
  EXPECT_NEAR(whole[0].area, 1500, 10);
  const std::vector<LowRegion> cut = FindWaterSurfaces(std::vector<GroundRaster>{Canal(50, 50), Canal(0, 52)});
  ASSERT_THAT(cut, SizeIs(1));
  EXPECT_EQ(cut[0].outline.rings, whole[0].outline.rings);
}

TEST(FindWaterSurfacesTest, CanalsFarApartAreFoundEachByItself) {
  const std::vector<GroundRaster> far = {Canal(2000000, 50), Canal(0, 100)};  // one raster of both: 640 MB
  const std::vector<LowRegion> both = FindWaterSurfaces(far);
  ASSERT_THAT(both, SizeIs(2));
  EXPECT_NEAR(both[0].area, 1500, 10);
  EXPECT_NEAR(both[1].area, 750, 10);
}

TEST(FindWaterSurfacesTest, WithoutSurfaceThereIsNone) { EXPECT_THAT(FindWaterSurfaces({}), SizeIs(0)); }

}  // namespace
}  // namespace tilemend
