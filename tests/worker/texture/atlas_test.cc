#include "worker/texture/atlas.h"

#include <gtest/gtest.h>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

const std::vector<Point3> kPoints = {{1, 1, 0}, {5, 1, 0}, {5, 4, 0}, {1, 4, 0}, {5, 4, 9}};

MadeRaster Made(const RasterFrame& frame) {
  const OrthoRaster raster = RasterOf(frame, [](int64_t x, int64_t y) {
    return Rgb{static_cast<uint8_t>(10 * x), static_cast<uint8_t>(10 * y), 77};
  });
  return {frame, raster.colours};
}

TEST(AtlasTest, FlatFacesShowTheRasterAtTheirPoints) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<MadeRaster> rasters = {Made({0.5, -4, -4, 24, 24})};
  const Atlas atlas = PackAtlas({kPoints, triangles, {0, 0}, std::vector<Rgb>(6)}, rasters);
  EXPECT_EQ(atlas.image.width, 16);  // 4 m at 0.5 m, and two gutters
  EXPECT_EQ(atlas.image.height, 16);
  EXPECT_EQ(atlas.coordinates.size(), 4U);
  for (size_t t = 0; t < 2; ++t) {
    for (size_t k = 0; k < 3; ++k) {
      const Point3& p = kPoints[static_cast<size_t>(triangles[t][k])];
      const auto& uv = atlas.coordinates[static_cast<size_t>(atlas.corners[t][k])];
      // A quarter of a texel towards the north-east, to be inside of a pixel.
      const Rgb c = TexelAt(atlas.image, double{uv[0]} + 0.25 / 16, double{uv[1]} + 0.25 / 16);
      EXPECT_EQ(c, (Rgb{static_cast<uint8_t>(20 * p.x()), static_cast<uint8_t>(20 * p.y()), 77}));
    }
  }
}

TEST(AtlasTest, SteepFacesHaveTheColoursOfTheirCorners) {
  const std::vector<Triangle> triangles = {{1, 2, 4}, {1, 4, 2}};
  const Rgb a{200, 0, 0}, b{0, 200, 0}, c{0, 0, 200};
  const Atlas atlas = PackAtlas({kPoints, triangles, {-1, -1}, {a, b, c, c, b, a}}, {});
  const std::vector<Rgb> wanted = {a, b, c, c, b, a};
  for (size_t i = 0; i < 6; ++i) {
    const auto& uv = atlas.coordinates[static_cast<size_t>(atlas.corners[i / 3][i % 3])];
    const Rgb seen = TexelAt(atlas.image, double{uv[0]}, double{uv[1]});
    EXPECT_NEAR(seen.r, wanted[i].r, 45);
    EXPECT_NEAR(seen.g, wanted[i].g, 45);
    EXPECT_NEAR(seen.b, wanted[i].b, 45);
  }
}

TEST(AtlasTest, CoordinatesStayHalfAPixelInside) {
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  // The raster ends before the faces do.
  const std::vector<MadeRaster> rasters = {Made({0.5, 3, 3, 6, 4})};
  const Atlas atlas = PackAtlas({kPoints, triangles, {0, 0}, std::vector<Rgb>(6)}, rasters);
  for (const auto& uv : atlas.coordinates) {
    EXPECT_GE(uv[0] * static_cast<float>(atlas.image.width), 0.5F);
    EXPECT_LE(uv[0] * static_cast<float>(atlas.image.width), 5.5F);
    EXPECT_GE(uv[1] * static_cast<float>(atlas.image.height), 0.5F);
    EXPECT_LE(uv[1] * static_cast<float>(atlas.image.height), 3.5F);
  }
}

TEST(AtlasTest, PartsDoNotOverlap) {
  const std::vector<Point3> points = {{1, 1, 0}, {5, 1, 0}, {5, 4, 0}, {101, 1, 0}, {105, 1, 0}, {105, 9, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}, {0, 1, 2}};
  const std::vector<MadeRaster> rasters = {Made({0.5, -4, -4, 24, 24}), Made({0.5, 196, -4, 24, 32})};
  const Atlas atlas = PackAtlas({points, triangles, {0, 1, -1}, std::vector<Rgb>(9, Rgb{1, 1, 1})}, rasters);
  const auto at = [&](size_t t, size_t k) { return atlas.coordinates[static_cast<size_t>(atlas.corners[t][k])]; };
  EXPECT_EQ(TexelAt(atlas.image, double{at(0, 0)[0]}, double{at(0, 0)[1]}).b, 77);
  EXPECT_EQ(TexelAt(atlas.image, double{at(1, 2)[0]}, double{at(1, 2)[1]}).g, 180);
  EXPECT_EQ(TexelAt(atlas.image, double{at(2, 0)[0]}, double{at(2, 0)[1]}), (Rgb{1, 1, 1}));
}

TEST(AtlasTest, PartsThatAreTooLargeAreHalved) {
  const std::vector<Point3> points = {{0, 0, 0}, {10000, 0, 0}, {10000, 2, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const std::vector<MadeRaster> rasters = {Made({1, -8, -8, 10016, 16})};
  const Atlas atlas = PackAtlas({points, triangles, {0}, std::vector<Rgb>(3)}, rasters);
  EXPECT_EQ(atlas.image.width, 8192);
  EXPECT_EQ(atlas.image.height, 8);
}

TEST(AtlasTest, SteepFacesOfEqualColoursShareASquare) {
  const std::vector<Triangle> triangles(1000, Triangle{1, 2, 4});
  const std::vector<int32_t> steep(triangles.size(), -1);
  const Atlas atlas = PackAtlas({kPoints, triangles, steep, std::vector<Rgb>(3000, Rgb{9, 8, 7})}, {});
  EXPECT_EQ(atlas.image.width, 8);
  EXPECT_EQ(atlas.image.height, 8);
  EXPECT_EQ(atlas.coordinates.size(), 3U);
  EXPECT_EQ(atlas.corners.size(), triangles.size());
}

// 1024 x 1024 squares of 8 pixels fill the largest image.
TEST(AtlasTest, MoreSteepFacesThanTheImageHasSquaresRoundTheirColours) {
  constexpr size_t kFaces = 1024 * 1024 + 1;
  const std::vector<Triangle> triangles(kFaces, Triangle{1, 2, 4});
  std::vector<Rgb> colours(3 * kFaces);
  for (size_t t = 0; t < kFaces; ++t) {
    for (size_t k = 0; k < 3; ++k) {
      colours[3 * t + k] = {static_cast<uint8_t>(t), static_cast<uint8_t>(t >> 8), static_cast<uint8_t>(t >> 16)};
    }
  }
  const Atlas atlas = PackAtlas({kPoints, triangles, std::vector<int32_t>(kFaces, -1), colours}, {});
  EXPECT_LE(atlas.image.width, 8192);
  EXPECT_LE(atlas.image.height, 8192);
  ASSERT_EQ(atlas.corners.size(), kFaces);
  for (size_t t = 0; t < kFaces; t += 9973) {
    const auto& uv = atlas.coordinates[static_cast<size_t>(atlas.corners[t][0])];
    const Rgb seen = TexelAt(atlas.image, double{uv[0]}, double{uv[1]});
    EXPECT_NEAR(seen.r, colours[3 * t].r, 1);
    EXPECT_NEAR(seen.g, colours[3 * t].g, 1);
    EXPECT_NEAR(seen.b, colours[3 * t].b, 1);
  }
}

TEST(AtlasTest, SteepFacesLeaveRoomForTheRasters) {
  constexpr size_t kSteep = 600'000;
  std::vector<Triangle> triangles(kSteep, Triangle{1, 2, 4});
  std::vector<int32_t> rasters(kSteep, -1);
  triangles.push_back({0, 1, 2});
  rasters.push_back(0);
  std::vector<Rgb> colours(3 * triangles.size());
  for (size_t i = 0; i < colours.size(); ++i) {
    const uint32_t mixed = static_cast<uint32_t>(i) * 2654435761U;  // all bits differ from face to face
    colours[i] = {static_cast<uint8_t>(mixed >> 24), static_cast<uint8_t>(mixed >> 16),
                  static_cast<uint8_t>(mixed >> 8)};
  }
  const std::vector<MadeRaster> made = {Made({0.5, -4, -4, 24, 24})};
  const Atlas atlas = PackAtlas({kPoints, triangles, rasters, colours}, made);
  const auto& uv = atlas.coordinates[static_cast<size_t>(atlas.corners.back()[0])];
  EXPECT_EQ(TexelAt(atlas.image, double{uv[0]} + 1e-5, double{uv[1]} + 1e-5), (Rgb{20, 20, 77}));
}

TEST(AtlasTest, PixelsBetweenThePartsHaveTheMeanColour) {
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const RasterFrame frame{0.5, -4, -4, 24, 24};
  const std::vector<MadeRaster> rasters = {{frame, std::vector<Rgb>(frame.size(), Rgb{90, 60, 30})}};
  const std::vector<Point3> points = {{1, 1, 0}, {5, 1, 0}, {5, 2, 0}};
  const Atlas atlas = PackAtlas({points, triangles, {0}, std::vector<Rgb>(3)}, rasters);
  ASSERT_EQ(atlas.image.height, 16);  // more than the 10 pixels of the part
  for (size_t i = 0; i < atlas.image.pixels.size(); i += 3) {
    EXPECT_EQ((Rgb{atlas.image.pixels[i], atlas.image.pixels[i + 1], atlas.image.pixels[i + 2]}), (Rgb{90, 60, 30}));
  }
}

}  // namespace
}  // namespace tilemend
