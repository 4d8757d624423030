#include "worker/texture/streamlines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "worker/texture/base_colours.h"

namespace tilemend {
namespace {

constexpr double kGradientSquare = 0.25;  // metres
constexpr double kFieldSquare = 1;
constexpr double kFieldSmooth = 15;
constexpr float kSaturated = 12;    // grey levels between neighbours
constexpr double kSampleWay = 12;   // metres of ground that a streamline looks at
constexpr double kLongestWay = 60;  // metres to the ground
constexpr double kStep = 0.5;
constexpr float kNoStructure = 0.25F, kFullStructure = 0.4F;

SquareLattice BrightnessSquares(const OrthoRaster& raster, const PixelMask& sources) {
  SquareLattice grey = LatticeOver(raster.frame, kGradientSquare);
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y), square = SquareOf(grey, raster.frame, x, y);
      if (sources[at] == 0) continue;
      grey.values[square][0] += Brightness(ChannelsOf(raster.colours[at]));
      grey.weights[square] += 1;
    }
  }
  for (size_t i = 0; i < grey.values.size(); ++i) {
    if (grey.weights[i] > 0) grey.values[i][0] /= grey.weights[i];
  }
  return grey;
}

// The saturated tensor at a square of the brightness; nothing where a neighbour is not known.
std::optional<Channels> TensorAt(const SquareLattice& grey, int32_t x, int32_t y) {
  if (x < 1 || y < 1 || x + 1 >= grey.width || y + 1 >= grey.height) return std::nullopt;
  const std::array<size_t, 4> around = {grey.At(x - 1, y), grey.At(x + 1, y), grey.At(x, y - 1), grey.At(x, y + 1)};
  for (const size_t at : around) {
    if (!(grey.weights[at] > 0)) return std::nullopt;
  }
  const float gx = grey.values[around[1]][0] - grey.values[around[0]][0];
  const float gy = grey.values[around[3]][0] - grey.values[around[2]][0];
  const float length = std::sqrt(gx * gx + gy * gy);
  const float scale = length > kSaturated ? kSaturated / length : 1;
  return Channels{scale * scale * gx * gx, scale * scale * gx * gy, scale * scale * gy * gy};
}

// Direction along the structure and coherence of a tensor.
Channels DirectionOf(const Channels& tensor) {
  const double xx = tensor[0], xy = tensor[1], yy = tensor[2];
  const double spread = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy), sum = xx + yy;
  if (!(sum > 0) || !(spread > 0)) return {1, 0, 0};
  const double across = 0.5 * std::atan2(2 * xy, xx - yy);
  return {static_cast<float>(-std::sin(across)), static_cast<float>(std::cos(across)),
          static_cast<float>(spread / sum)};
}

class Tracer {
 public:
  Tracer(const OrthoRaster& raster, const PixelMask& sources, const StructureField& field)
      : raster_(raster),
        frame_(raster.frame),
        sources_(sources),
        squares_(field.squares),
        step_(std::max(1.0, kStep / frame_.texel)) {}

  struct Found {
    Channels colour{};
    double distance = 0;  // to the first source, in pixels
  };

  // From the centre of a pixel along the field, in its direction or against it.
  std::optional<Found> Trace(int32_t x, int32_t y, double sign) {
    for (auto& channel : seen_) channel.clear();
    const Channels& start = squares_.values[SquareOf(squares_, frame_, x, y)];
    double dx = sign * double{start[0]}, dy = sign * double{start[1]}, px = x + 0.5, py = y + 0.5, way = 0, first = -1;
    while (first < 0 ? way < kLongestWay / frame_.texel : way < first + 2 * kSampleWay / frame_.texel) {
      px += step_ * dx;
      py += step_ * dy;
      way += step_;
      const auto qx = static_cast<int64_t>(std::floor(px)), qy = static_cast<int64_t>(std::floor(py));
      if (!frame_.Has(qx, qy)) break;
      const auto ix = static_cast<int32_t>(qx), iy = static_cast<int32_t>(qy);
      if (const size_t at = frame_.At(ix, iy); sources_[at] != 0) {
        if (first < 0) first = way;
        Take(raster_.colours[at]);
        if (static_cast<double>(seen_[0].size()) * step_ * frame_.texel >= kSampleWay) break;
      }
      const Channels& d = squares_.values[SquareOf(squares_, frame_, ix, iy)];
      const double turn = dx * double{d[0]} + dy * double{d[1]} < 0 ? -1 : 1;
      dx = turn * double{d[0]};
      dy = turn * double{d[1]};
    }
    if (first < 0) return std::nullopt;
    return Found{Median(), first};
  }

 private:
  void Take(Rgb c) {
    seen_[0].push_back(c.r);
    seen_[1].push_back(c.g);
    seen_[2].push_back(c.b);
  }
  Channels Median() {
    Channels result;
    for (size_t c = 0; c < 3; ++c) {
      const auto middle = seen_[c].begin() + static_cast<std::ptrdiff_t>(seen_[c].size() / 2);
      std::nth_element(seen_[c].begin(), middle, seen_[c].end());
      result[c] = *middle;
    }
    return result;
  }

  const OrthoRaster& raster_;
  const RasterFrame& frame_;
  const PixelMask& sources_;
  const SquareLattice& squares_;
  const double step_;  // pixels
  std::array<std::vector<uint8_t>, 3> seen_;
};

}  // namespace

StructureField StructureOf(const OrthoRaster& raster, const PixelMask& sources) {
  const SquareLattice grey = BrightnessSquares(raster, sources);
  StructureField field{LatticeOver(raster.frame, kFieldSquare)};
  SquareLattice& squares = field.squares;
  const int32_t ratio = std::max(1, squares.pixels / grey.pixels);
  for (int32_t y = 0; y < grey.height; ++y) {
    for (int32_t x = 0; x < grey.width; ++x) {
      const std::optional<Channels> tensor = TensorAt(grey, x, y);
      if (!tensor) continue;
      const auto column =
          static_cast<int32_t>(((grey.column + x) >> std::countr_zero(static_cast<uint32_t>(ratio))) - squares.column);
      const auto row =
          static_cast<int32_t>(((grey.row + y) >> std::countr_zero(static_cast<uint32_t>(ratio))) - squares.row);
      const size_t at = squares.At(column, row);
      for (size_t c = 0; c < 3; ++c) squares.values[at][c] += (*tensor)[c];
      squares.weights[at] += 1;
    }
  }
  for (size_t i = 0; i < squares.values.size(); ++i) {
    if (squares.weights[i] > 0) {
      for (float& value : squares.values[i]) value /= squares.weights[i];
    }
  }
  SmoothSquares(kFieldSmooth / (squares.pixels * raster.frame.texel), squares);
  FillSquares(squares);
  for (Channels& value : squares.values) value = DirectionOf(value);
  return field;
}

void CarryStructure(const OrthoRaster& raster, const PixelMask& sources, const StructureField& field,
                    const PixelMask& make, std::vector<Channels>& colours) {
  Tracer tracer(raster, sources, field);
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      if (make[at] == 0) continue;
      const float coherence = field.squares.values[SquareOf(field.squares, raster.frame, x, y)][2];
      const float share = std::clamp((coherence - kNoStructure) / (kFullStructure - kNoStructure), 0.0F, 1.0F);
      if (share <= 0) continue;
      Channels sum{};
      double weights = 0;
      for (const double sign : {1.0, -1.0}) {
        const auto found = tracer.Trace(x, y, sign);
        if (!found) continue;
        const double weight = 1 / found->distance;
        for (size_t c = 0; c < 3; ++c) sum[c] += static_cast<float>(weight) * found->colour[c];
        weights += weight;
      }
      if (!(weights > 0)) continue;
      for (size_t c = 0; c < 3; ++c) {
        colours[at][c] += share * (sum[c] / static_cast<float>(weights) - colours[at][c]);
      }
    }
  }
}

}  // namespace tilemend
