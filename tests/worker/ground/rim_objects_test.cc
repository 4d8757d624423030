#include "worker/ground/rim_objects.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/ground_rasters.h"

namespace tilemend {
namespace {

// A house on flat ground.
double House(int32_t c, int32_t r) { return c >= 40 && c < 52 && r >= 40 && r < 52 ? 7 : 0; }

TEST(GroundAtRimTest, VerticesOnAHouseAndAboveTheGroundAre) {
  const std::vector<GroundRaster> rasters = {BuiltRaster(0, 0, 100, 100, House)};
  const std::vector<Point3> vertices = {{45.5, 45.5, 7}, {30.5, 30.5, 0}, {30.2, 30.7, 0.4}, {30.5, 30.5, 3}};
  EXPECT_EQ(GroundAtRim(vertices, rasters).on_object, (std::vector<bool>{true, false, false, true}));
}

TEST(GroundAtRimTest, TellsTheGroundUnderAHouse) {
  const auto slope = [](int32_t c, int32_t r) { return 0.05 * c + House(c, r); };
  const std::vector<GroundRaster> rasters = {BuiltRaster(0, 0, 100, 100, slope)};
  const RimGround rim = GroundAtRim(std::vector<Point3>{{45.5, 45.5, 9.25}, {20.5, 30.5, 1}}, rasters);
  EXPECT_NEAR(rim.ground[0], 0.05 * 45, 0.05);
  EXPECT_FLOAT_EQ(rim.ground[1], 1);
}

// The house lies over the border; each tile alone would have half of it.
TEST(GroundAtRimTest, TilesAreJoinedAndTheLowestCounts) {
  std::vector<GroundRaster> rasters = {BuiltRaster(0, 0, 46, 100, House), BuiltRaster(46, 0, 54, 100, House)};
  const std::vector<Point3> vertices = {{45.5, 45.5, 7}, {46.5, 45.5, 7}, {60.5, 45.5, 0}};
  EXPECT_EQ(GroundAtRim(vertices, rasters).on_object, (std::vector<bool>{true, true, false}));
  rasters.push_back(BuiltRaster(56, 41, 9, 9, [](int32_t, int32_t) { return -2; }));
  EXPECT_EQ(GroundAtRim(vertices, rasters).on_object, (std::vector<bool>{true, true, true}))
      << "2 m above the lower surface";
}

TEST(GroundAtRimTest, DoesNotDependOnTheOtherVerticesThatAreAsked) {
  const std::vector<GroundRaster> rasters = {BuiltRaster(0, 0, 400, 300, [](int32_t c, int32_t r) {
    return 0.02 * c + (c * 13 + r * 7) % 29 * 0.02 + (c / 20 % 3 == 0 && r / 15 % 2 == 0 ? 6 : 0);
  })};
  std::vector<Point3> vertices;
  for (int k = 0; k < 12; ++k) {
    const int c = 37 * k % 400, r = 53 * k % 300;
    vertices.emplace_back(c + 0.5, r + 0.5, rasters[0].heights[rasters[0].IndexOf(c, r)]);
  }
  const std::vector<bool> all = GroundAtRim(vertices, rasters).on_object;
  for (size_t v = 0; v < vertices.size(); ++v) {
    EXPECT_EQ(GroundAtRim(std::vector<Point3>{vertices[v]}, rasters).on_object[0], all[v]) << v;
  }
}

TEST(GroundAtRimTest, WithoutSurfaceNothingIs) {
  const std::vector<Point3> vertices = {{500.5, 3, 7}};
  EXPECT_EQ(GroundAtRim(vertices, {}).on_object, std::vector<bool>{false});
  EXPECT_EQ(GroundAtRim(vertices, std::vector<GroundRaster>{GroundRaster()}).on_object, std::vector<bool>{false});
  EXPECT_EQ(GroundAtRim(vertices, std::vector<GroundRaster>{BuiltRaster(0, 0, 9, 9, House)}).on_object,
            std::vector<bool>{false});
  EXPECT_TRUE(GroundAtRim({}, std::vector<GroundRaster>{BuiltRaster(0, 0, 9, 9, House)}).on_object.empty());
}

}  // namespace
}  // namespace tilemend
