#include "worker/ground/ground_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace tilemend {
namespace {

using Height = std::function<double(double x, double y)>;  // NaN: no surface

GroundRaster Raster(int32_t cols, int32_t rows, const Height& height) {
  GroundRaster raster = EmptyRaster(1, 0, 0, cols, rows);
  for (int32_t r = 0; r < rows; ++r) {
    for (int32_t c = 0; c < cols; ++c) raster.heights[raster.IndexOf(c, r)] = static_cast<float>(height(c, r));
  }
  return raster;
}

// How many squares are no ground, and how many should not be.
struct Counts {
  int wrong_ground = 0, wrong_objects = 0, objects = 0;
};

Counts Compare(const GroundRaster& raster, const std::function<bool(double, double)>& is_object) {
  const FilteredGround filtered(raster, {});
  Counts counts;
  for (int32_t r = 0; r < raster.rows; ++r) {
    for (int32_t c = 0; c < raster.cols; ++c) {
      if (std::isnan(raster.heights[raster.IndexOf(c, r)])) continue;
      const FilteredGround::Place place = filtered.GroundAt(c, r);
      const bool ground = std::abs(raster.heights[raster.IndexOf(c, r)] - place.height) <= place.tolerance;
      counts.objects += is_object(c, r);
      counts.wrong_ground += ground && is_object(c, r);
      counts.wrong_objects += !ground && !is_object(c, r);
    }
  }
  return counts;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(FilteredGroundTest, HousesOnASlopeAreObjects) {
  const auto house = [](double x, double y) { return x > 60 && x < 90 && y > 50 && y < 80; };
  const Counts counts =
      Compare(Raster(160, 150, [&](double x, double y) { return 0.08 * x + (house(x, y) ? 9 : 0); }), house);
  EXPECT_EQ(counts.objects, 29 * 29);
  EXPECT_EQ(counts.wrong_ground + counts.wrong_objects, 0);
}

// Of narrow crests the filter takes some squares for objects.
TEST(FilteredGroundTest, HillsAreGround) {
  const auto hills = [](double x, double y) { return 12 * std::sin(x / 60) * std::sin(y / 70); };
  EXPECT_EQ(Compare(Raster(200, 200, hills), [](double, double) { return false; }).wrong_objects, 0);
  const auto crests = [](double x, double y) { return 12 * std::sin(x / 30) * std::sin(y / 40); };
  EXPECT_LE(Compare(Raster(200, 200, crests), [](double, double) { return false; }).wrong_objects, 0.02 * 200 * 200);
}

// A quay stays ground on both sides: it is wider than the window.
TEST(FilteredGroundTest, AQuayIsGround) {
  const Counts counts = Compare(Raster(300, 80, [](double x, double) { return x < 150 ? 0 : 1.5; }),
                                [](double, double) { return false; });
  EXPECT_EQ(counts.wrong_objects, 0);
}

// Houses all around a hole, and streets behind them: the hole neither lets them be ground nor the streets objects.
TEST(FilteredGroundTest, WhatHasNoSurfaceNeitherLowersNorLifts) {
  const auto hole = [](double x, double y) { return std::hypot(x - 100, y - 100) < 30; };
  const auto house = [&](double x, double y) { return !hole(x, y) && std::hypot(x - 100, y - 100) < 42; };
  const Counts counts =
      Compare(Raster(200, 200, [&](double x, double y) { return hole(x, y) ? kNone : (house(x, y) ? 10 : 0); }), house);
  EXPECT_GT(counts.objects, 1000);
  EXPECT_EQ(counts.wrong_ground + counts.wrong_objects, 0);
}

TEST(FilteredGroundTest, APitIsNoGround) {
  GroundRaster raster = Raster(60, 60, [](double, double) { return 4; });
  raster.heights[raster.IndexOf(30, 30)] = -20;
  const FilteredGround filtered(raster, {});
  EXPECT_FALSE(filtered.IsGround(30, 30));
  EXPECT_EQ(filtered.GroundAt(30, 30).height, 4);
  EXPECT_EQ(filtered.GroundAt(31, 30).height, 4);
}

// What is told of a place depends on the surface within the reach alone.
TEST(FilteredGroundTest, IsTheSameOfAPartWithItsSurroundings) {
  const Height height = [](double x, double y) {
    return 3 * std::sin(x / 17) + 2 * std::cos(y / 23) + (std::fmod(x * 7 + y * 3, 41) < 5 ? 6 : 0);
  };
  const GroundFilterOptions options{.window = 12};
  const auto reach = static_cast<int32_t>(FilterReach(options)) + 1;
  const FilteredGround whole(Raster(160, 140, height), options);
  const int32_t col = 60, row = 50, cols = 10, rows = 8;
  const GroundRaster part = Raster(cols + 2 * reach, rows + 2 * reach,
                                   [&](double x, double y) { return height(x + col - reach, y + row - reach); });
  const FilteredGround filtered(part, options);
  for (int32_t r = 0; r < rows; ++r) {
    for (int32_t c = 0; c < cols; ++c) {
      const auto a = whole.GroundAt(col + c, row + r), b = filtered.GroundAt(c + reach, r + reach);
      EXPECT_TRUE(a.height == b.height || (std::isnan(a.height) && std::isnan(b.height))) << c << " " << r;
      EXPECT_TRUE(a.tolerance == b.tolerance) << c << " " << r;
    }
  }
}

// Rasters that span more than an int16 has steps are filtered in larger steps.
TEST(FilteredGroundTest, MountainsAreGround) {
  GroundRaster raster = Raster(200, 200, [](double, double y) { return 12 * y; });
  raster.square = 32;
  EXPECT_EQ(Compare(raster, [](double, double) { return false; }).wrong_objects, 0);
}

TEST(FilteredGroundTest, NothingComesOfNothing) {
  EXPECT_FALSE(FilteredGround({}, {}).IsGround(0, 0));
  const FilteredGround empty(EmptyRaster(1, 0, 0, 5, 5), {});
  EXPECT_FALSE(empty.IsGround(2, 2));
  EXPECT_TRUE(std::isnan(empty.GroundAt(2, 2).height));
}

}  // namespace
}  // namespace tilemend
