#include "worker/texture/base_colours.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr double kBaseSquare = 0.5;  // metres
constexpr double kSmooth = 0.8;      // metres
constexpr float kShadow = 0.6F;      // of the brightness around
constexpr int kMiddleSteps = 20;
constexpr double kMiddleSquare = 8, kMiddleReach = 40;  // metres
constexpr double kWeightOfAll = 1;                      // squares
constexpr double kNearMiddle = 0.5;  // grey levels: a square on the middle itself must not hold it there

// The mean of the two in the middle, of an even number.
float MedianOf(std::vector<uint8_t>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (static_cast<float>(*middle) + static_cast<float>(*std::max_element(values.begin(), middle))) / 2;
}

Eigen::Array3d ValueOf(const Channels& c) { return {double{c[0]}, double{c[1]}, double{c[2]}}; }

Channels ChannelsOf(const Eigen::Array3d& value) {
  const Eigen::Array3f result = value.cast<float>();
  return {result[0], result[1], result[2]};
}

struct Voter {
  Eigen::Array3d value;
  double weight = 0;
};

Eigen::Array3d WeightedMiddle(std::span<const Voter> voters) {
  Eigen::Array3d middle = Eigen::Array3d::Zero();
  for (int step = 0; step <= kMiddleSteps; ++step) {
    Eigen::Array3d sum = Eigen::Array3d::Zero();
    double weights = 0;
    for (const auto& [value, own] : voters) {
      const double weight = step == 0 ? own : own / std::max(kNearMiddle, (value - middle).matrix().norm());
      sum += weight * value;
      weights += weight;
    }
    middle = sum / weights;
  }
  return middle;
}

// Whether the square or one that touches it has a weight.
bool IsWantedBeside(const SquareLattice& lattice, int32_t column, int32_t row) {
  for (int32_t y = std::max(0, row - 1); y <= std::min(lattice.height - 1, row + 1); ++y) {
    for (int32_t x = std::max(0, column - 1); x <= std::min(lattice.width - 1, column + 1); ++x) {
      if (lattice.weights[lattice.At(x, y)] > 0) return true;
    }
  }
  return false;
}

// The known squares within `reach` pixels of the middle of a square of another lattice; the sum of their weights.
double CollectNear(const SquareLattice& middles, int32_t column, int32_t row, const SquareLattice& squares,
                   double reach, std::vector<Voter>& voters) {
  voters.clear();
  const double x = (static_cast<double>(middles.column + column) + 0.5) * middles.pixels;
  const double y = (static_cast<double>(middles.row + row) + 0.5) * middles.pixels;
  const auto range = [&](double middle, int64_t first, int32_t count) {
    const auto square = [&](double at) { return std::floor(at / squares.pixels) - static_cast<double>(first); };
    return std::pair(static_cast<int32_t>(std::clamp(square(middle - reach), 0.0, double{1} * count)),
                     static_cast<int32_t>(std::clamp(square(middle + reach) + 1, 0.0, double{1} * count)));
  };
  const auto [x0, x1] = range(x, squares.column, squares.width);
  const auto [y0, y1] = range(y, squares.row, squares.height);
  double sum = 0;
  for (int32_t j = y0; j < y1; ++j) {
    for (int32_t i = x0; i < x1; ++i) {
      const size_t at = squares.At(i, j);
      if (!(squares.weights[at] > 0)) continue;
      const double dx = (static_cast<double>(squares.column + i) + 0.5) * squares.pixels - x;
      const double dy = (static_cast<double>(squares.row + j) + 0.5) * squares.pixels - y;
      const double inside = 1 - (dx * dx + dy * dy) / (reach * reach);
      if (inside <= 0) continue;
      voters.push_back({ValueOf(squares.values[at]), inside * inside});
      sum += inside * inside;
    }
  }
  return sum;
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
  std::vector<Voter> voters;
  for (size_t i = 0; i < squares.values.size(); ++i) {
    if (squares.weights[i] > 0) voters.push_back({ValueOf(squares.values[i]), 1});
  }
  return ChannelsOf(WeightedMiddle(voters));
}

SquareLattice MiddlesNear(const RasterFrame& frame, const SquareLattice& squares, const PixelMask& wanted) {
  const Eigen::Array3d all = ValueOf(MiddleOf(squares));
  SquareLattice middles = LatticeOver(frame, kMiddleSquare);
  for (int32_t y = 0; y < frame.height; ++y) {
    for (int32_t x = 0; x < frame.width; ++x) {
      if (wanted[frame.At(x, y)] != 0) middles.weights[SquareOf(middles, frame, x, y)] = 1;
    }
  }
  std::vector<Voter> voters;
  for (int32_t row = 0; row < middles.height; ++row) {
    for (int32_t column = 0; column < middles.width; ++column) {
      if (!IsWantedBeside(middles, column, row)) continue;
      const double weight = CollectNear(middles, column, row, squares, kMiddleReach / frame.texel, voters);
      const Eigen::Array3d near = voters.empty() ? all : WeightedMiddle(voters);
      middles.values[middles.At(column, row)] =
          ChannelsOf((weight * near + kWeightOfAll * all) / (weight + kWeightOfAll));
    }
  }
  return middles;
}

}  // namespace tilemend
