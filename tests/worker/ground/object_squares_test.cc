#include "worker/ground/object_squares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

const std::vector<OpeningStep> kSteps = {{1, 6},   {2, 13},  {4, 26},   {7, 45},  {8, 51},
                                         {10, 64}, {14, 90}, {24, 154}, {37, 237}};

// Waves on a slope with noise, houses on it, and a share of squares without surface.
StepRaster City(int32_t cols, int32_t rows, int houses, double slope, uint32_t seed) {
  StepRaster raster{cols, rows, {}};
  std::mt19937 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<uint32_t>(n)); };
  for (int32_t r = 0; r < rows; ++r) {
    for (int32_t c = 0; c < cols; ++c) {
      raster.heights.push_back(
          static_cast<int16_t>(slope * c + 60 * std::sin(c * 0.1) * std::cos(r * 0.07) + below(20)));
    }
  }
  for (int h = 0; h < houses; ++h) {
    const int col = below(cols), row = below(rows), width = 3 + below(25), depth = 3 + below(25),
              height = 100 + below(900);
    for (int r = row; r < std::min(row + depth, rows); ++r) {
      for (int c = col; c < std::min(col + width, cols); ++c)
        raster.heights[r * cols + c] += static_cast<int16_t>(height);
    }
  }
  for (int16_t& height : raster.heights) height = below(30) == 0 ? kNoSurface : height;
  return raster;
}

// By the definition, with all openings over the whole raster.
std::vector<uint8_t> Expected(const StepRaster& surface, const std::vector<OpeningStep>& steps) {
  std::vector<uint8_t> objects(surface.heights.size(), 0);
  StepRaster before = surface;
  for (const OpeningStep& step : steps) {
    StepRaster opened = OpenedByDisk(surface, step.radius);
    for (size_t i = 0; i < objects.size(); ++i) {
      if (before.heights[i] - opened.heights[i] > step.most) objects[i] = 1;
    }
    before = opened;
  }
  return objects;
}

void ExpectTheSame(const StepRaster& surface, const SquareBlocks& asked, const std::vector<OpeningStep>& steps) {
  const std::vector<uint8_t> objects = ObjectSquares(surface, asked, steps), expected = Expected(surface, steps);
  asked.ForRuns([&](int32_t row, int32_t first, int32_t end) {
    for (int32_t col = first; col < end; ++col) {
      const size_t i = static_cast<size_t>(row) * surface.cols + col;
      if (surface.heights[i] == kNoSurface) continue;
      ASSERT_EQ(objects[i], expected[i]) << col << " " << row;
    }
  });
}

TEST(ObjectSquaresTest, AreThoseOfAllOpeningsOverTheWholeRaster) {
  for (const int houses : {0, 2, 12, 60}) {
    for (const double slope : {0.0, 8.0, -30.0}) {
      const StepRaster surface = City(103, 140, houses, slope, 7 + houses);
      SCOPED_TRACE(testing::Message() << houses << " houses, slope " << slope);
      ExpectTheSame(surface, SquareBlocks::All(103, 140), kSteps);
      SquareBlocks some(103, 140);
      for (int k = 0; k < 9; ++k) some.Add(11 * k, 15 * k);
      ExpectTheSame(surface, some, kSteps);
    }
  }
}

// A disk beyond the raster's edge would have no low surface in it, and is none of the opening's.
TEST(ObjectSquaresTest, AHouseAtTheEdgeIsAnObject) {
  StepRaster surface{99, 160, std::vector<int16_t>(99 * 160, 0)};
  for (int32_t r = 40; r < 120; ++r) {
    for (int32_t c = 80; c < 99; ++c) surface.heights[r * 99 + c] = 500;
  }
  const std::vector<uint8_t> objects = ObjectSquares(surface, SquareBlocks::All(99, 160), kSteps);
  for (size_t i = 0; i < objects.size(); ++i)
    ASSERT_EQ(objects[i] != 0, surface.heights[i] == 500) << i % 99 << " " << i / 99;
}

void Raise(int32_t first, int32_t end, int16_t by, StepRaster& surface) {
  for (int32_t r = first; r < end; ++r) {
    for (int32_t c = first; c < end; ++c) surface.heights[r * surface.cols + c] += by;
  }
}

// The second opening is not made at the bump, which it lowers by less than its `most`. The third one is, and has to be
// compared with the second.
TEST(ObjectSquaresTest, AnOpeningIsComparedWithTheOneBeforeThoughThatWasNotMadeThere) {
  StepRaster surface{200, 200, std::vector<int16_t>(200 * 200, 0)};
  Raise(70, 130, 200, surface);
  Raise(90, 110, 100, surface);
  const std::vector<OpeningStep> steps = {{7, 45}, {24, 154}, {37, 237}};
  ExpectTheSame(surface, SquareBlocks::All(200, 200), steps);
  EXPECT_EQ(ObjectSquares(surface, SquareBlocks::All(200, 200), steps)[100 * 200 + 100], 0);
}

TEST(ObjectSquaresTest, ThereAreNoneWithoutSteps) {
  const StepRaster surface = City(40, 20, 9, 0, 3);
  EXPECT_EQ(ObjectSquares(surface, SquareBlocks::All(40, 20), {}), std::vector<uint8_t>(800, 0));
}

}  // namespace
}  // namespace tilemend
