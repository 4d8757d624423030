#include "worker/ground/disk_opening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

namespace tilemend {
namespace {

StepRaster Random(int32_t cols, int32_t rows, uint32_t seed, double share_without_surface) {
  StepRaster raster{cols, rows, {}};
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> height(-500, 500);
  std::bernoulli_distribution none(share_without_surface);
  for (int32_t i = 0; i < cols * rows; ++i) {
    raster.heights.push_back(none(random) ? kNoSurface : static_cast<int16_t>(height(random)));
  }
  return raster;
}

// By the definition.
StepRaster Lowest(const StepRaster& raster, int32_t radius, bool highest) {
  StepRaster result = raster;
  for (int32_t r = 0; r < raster.rows; ++r) {
    for (int32_t c = 0; c < raster.cols; ++c) {
      int best = kNoSurface;
      for (int32_t y = std::max(0, r - radius); y <= std::min(raster.rows - 1, r + radius); ++y) {
        for (int32_t x = std::max(0, c - radius); x <= std::min(raster.cols - 1, c + radius); ++x) {
          const int16_t h = raster.heights[y * raster.cols + x];
          if (h == kNoSurface || (x - c) * (x - c) + (y - r) * (y - r) > radius * radius) continue;
          best = best == kNoSurface ? h : (highest ? std::max<int>(best, h) : std::min<int>(best, h));
        }
      }
      result.heights[r * raster.cols + c] = static_cast<int16_t>(best);
    }
  }
  return result;
}

TEST(OpenedByDiskTest, IsTheHighestOfTheLowestOverEachDisk) {
  for (const int32_t radius : {0, 1, 2, 5, 8}) {
    for (const double none : {0.0, 0.3, 0.95}) {
      const StepRaster raster = Random(23, 17, 5 + radius, none);
      EXPECT_EQ(OpenedByDisk(raster, radius).heights, Lowest(Lowest(raster, radius, false), radius, true).heights)
          << radius << " " << none;
    }
  }
}

TEST(OpenedByDiskTest, IsTheSameInTheSquaresThatAreAskedFor) {
  const StepRaster raster = Random(150, 90, 11, 0.1);
  SquareBlocks asked(raster.cols, raster.rows);
  for (const auto& [col, row] : {std::pair(3, 4), std::pair(70, 33), std::pair(80, 33), std::pair(149, 89)}) {
    asked.Add(col, row);
  }
  for (const int32_t radius : {1, 5, 8, 20}) {
    const StepRaster all = OpenedByDisk(raster, radius), part = OpenedByDisk(raster, radius, asked);
    asked.ForRuns([&](int32_t row, int32_t first, int32_t end) {
      for (int32_t col = first; col < end; ++col) {
        ASSERT_EQ(part.heights[row * raster.cols + col], all.heights[row * raster.cols + col])
            << radius << ": " << col << " " << row;
      }
    });
  }
}

TEST(OpenedByDiskTest, IsNowhereAboveTheSurface) {
  const StepRaster raster = Random(40, 30, 3, 0.2);
  const StepRaster opened = OpenedByDisk(raster, 6);
  for (size_t i = 0; i < raster.heights.size(); ++i) EXPECT_LE(opened.heights[i], raster.heights[i]);
}

TEST(OpenedByDiskTest, WithoutSurfaceNothingIsThere) {
  const StepRaster raster{4, 3, std::vector<int16_t>(12, kNoSurface)};
  EXPECT_EQ(OpenedByDisk(raster, 3).heights, raster.heights);
}

TEST(OpenedByDiskTest, TakesARasterOfNoSquares) { EXPECT_TRUE(OpenedByDisk({}, 3).heights.empty()); }

}  // namespace
}  // namespace tilemend
