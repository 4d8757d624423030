#include "worker/texture/base_colours.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

namespace tilemend {
namespace {

constexpr double kBaseSquare = 0.5;  // metres
constexpr double kSmooth = 0.8;      // metres
constexpr float kShadow = 0.6F;      // of the brightness around
constexpr int kMiddleSteps = 20;
constexpr double kNearMiddle = 0.5;  // grey levels: a square on the middle itself must not hold it there

// The mean of the two in the middle, of an even number.
float MedianOf(std::vector<uint8_t>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (static_cast<float>(*middle) + static_cast<float>(*std::max_element(values.begin(), middle))) / 2;
}

}  // namespace

float Brightness(const Channels& colour) { return 0.299F * colour[0] + 0.587F * colour[1] + 0.114F * colour[2]; }

Channels ChannelsOf(Rgb colour) {
  return {static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)};
}

SquareLattice MedianSquares(const OrthoRaster& raster, const PixelMask& sources) {
  SquareLattice squares = LatticeOver(raster.frame, kBaseSquare);
  const RasterFrame& frame = raster.frame;
  std::array<std::vector<uint8_t>, 3> seen;
  for (int32_t row = 0; row < squares.height; ++row) {
    for (int32_t column = 0; column < squares.width; ++column) {
      const int64_t x0 = (squares.column + column) * squares.pixels - frame.column;
      const int64_t y0 = (squares.row + row) * squares.pixels - frame.row;
      for (auto& channel : seen) channel.clear();
      for (int64_t y = std::max<int64_t>(y0, 0); y < std::min<int64_t>(y0 + squares.pixels, frame.height); ++y) {
        for (int64_t x = std::max<int64_t>(x0, 0); x < std::min<int64_t>(x0 + squares.pixels, frame.width); ++x) {
          const size_t at = frame.At(static_cast<int32_t>(x), static_cast<int32_t>(y));
          if (sources[at] == 0) continue;
          const Rgb c = raster.colours[at];
          seen[0].push_back(c.r);
          seen[1].push_back(c.g);
          seen[2].push_back(c.b);
        }
      }
      if (4 * seen[0].size() < static_cast<size_t>(squares.pixels) * static_cast<size_t>(squares.pixels)) continue;
      const size_t at = squares.At(column, row);
      squares.weights[at] = 1;
      for (size_t c = 0; c < 3; ++c) {
        squares.values[at][c] = MedianOf(seen[c]);
      }
    }
  }
  return squares;
}

void DropShadows(const OrthoRaster& raster, PixelMask& sources) {
  SquareLattice around = MedianSquares(raster, sources);
  SmoothSquares(kSmooth / (around.pixels * raster.frame.texel), around);
  FillSquares(around);
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      if (sources[at] == 0) continue;
      const float own = Brightness(ChannelsOf(raster.colours[at]));
      if (own < kShadow * Brightness(ValueAt(around, raster.frame, x, y))) sources[at] = 0;
    }
  }
}

Channels MiddleOf(const SquareLattice& squares) {
  Eigen::Array3d middle = Eigen::Array3d::Zero();
  for (int step = 0; step <= kMiddleSteps; ++step) {
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    double weights = 0;
    for (size_t i = 0; i < squares.values.size(); ++i) {
      if (!(squares.weights[i] > 0)) continue;
      const Channels& c = squares.values[i];
      const Eigen::Array3d value = {double{c[0]}, double{c[1]}, double{c[2]}};
      const double weight = step == 0 ? 1 : 1 / std::max(kNearMiddle, (value - middle).matrix().norm());
      sum += weight * value;
      weights += weight;
    }
    middle = sum / weights;
  }
  const Eigen::Array3f result = middle.cast<float>();
  return {result[0], result[1], result[2]};
}

}  // namespace tilemend
