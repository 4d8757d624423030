#include "worker/texture/level_paint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

constexpr Rgb kWest = {40, 80, 120}, kEast = {200, 160, 20};

MadeRaster Plain(const RasterFrame& frame, Rgb colour) { return {frame, std::vector<Rgb>(frame.size(), colour)}; }

// Two parts of 4 m beside each other, with rasters that reach over both.
LevelPaint TwoParts(std::map<std::array<double, 3>, Rgb> rim = {}) {
  FillParts parts;
  const RasterFrame frame{0.25, -16, -16, 64, 48};
  parts.frames = {frame, frame};
  parts.site = {1, 0, 0, 8, 4};
  for (int32_t y = 0; y < 4; ++y) {
    for (int32_t x = 0; x < 8; ++x) parts.of_squares.push_back(x < 4 ? 0 : 1);
  }
  return {parts, {Plain(frame, kWest), Plain(frame, kEast)}, std::move(rim)};
}

// The colour at a place given by shares of a triangle's corners.
Rgb ColourAt(const Atlas& atlas, size_t triangle, const std::array<double, 3>& shares) {
  double u = 0, v = 0;
  for (size_t k = 0; k < 3; ++k) {
    const auto& place = atlas.coordinates[static_cast<size_t>(atlas.corners[triangle][k])];
    u += shares[k] * double{place[0]};
    v += shares[k] * double{place[1]};
  }
  return TexelAt(atlas.image, u, v);
}

constexpr std::array<double, 3> kMiddle = {1. / 3, 1. / 3, 1. / 3};

TEST(LevelPaintTest, FacesTakeTheColourOfTheirPart) {
  LevelPaint paint = TwoParts();
  const std::vector<Point3> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {8, 0, 0}, {4, 4, 0}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 3, 4}};
  for (const int32_t above : {0, 1, 3}) {
    const Atlas atlas = paint.AtlasOf(points, triangles, std::vector<Rgb>(2), above);
    EXPECT_EQ(ColourAt(atlas, 0, kMiddle), kWest) << above;
    EXPECT_EQ(ColourAt(atlas, 1, kMiddle), kEast) << above;
  }
  const size_t fine = paint.AtlasOf(points, triangles, std::vector<Rgb>(2), 0).image.pixels.size(),
               coarse = paint.AtlasOf(points, triangles, std::vector<Rgb>(2), 1).image.pixels.size();
  EXPECT_LT(coarse, fine) << "half the texels along a side";
}

TEST(LevelPaintTest, ACoarseFaceOverTwoPartsShowsBoth) {
  LevelPaint paint = TwoParts();
  const std::vector<Point3> points = {{0, 0, 0}, {8, 0, 0}, {0, 4, 0}};
  const Atlas atlas = paint.AtlasOf(points, std::vector<Triangle>{{0, 1, 2}}, std::vector<Rgb>(1), 1);
  EXPECT_EQ(ColourAt(atlas, 0, {0.6, 0.1, 0.3}), kWest);
  EXPECT_EQ(ColourAt(atlas, 0, {0.1, 0.8, 0.1}), kEast);
}

TEST(LevelPaintTest, SteepFacesHangFromTheRim) {
  const Rgb wall = {9, 8, 7};
  LevelPaint paint = TwoParts({{{1, 1, 3}, wall}});
  const std::vector<Point3> points = {{1, 1, 0}, {2, 1, 0}, {1, 1, 3}, {50, 50, 0}, {51, 50, 0}, {50, 50, 3}};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {3, 4, 5}};
  const Rgb flat = {1, 2, 3};
  const Atlas atlas = paint.AtlasOf(points, triangles, std::vector<Rgb>{flat, flat}, 0);
  EXPECT_EQ(ColourAt(atlas, 0, kMiddle), wall);
  EXPECT_EQ(ColourAt(atlas, 1, kMiddle), flat) << "nothing else tells it";
}

}  // namespace
}  // namespace tilemend
