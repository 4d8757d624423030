#include "worker/texture/pixel_masks.h"

#include <algorithm>
#include <cmath>

namespace tilemend {
namespace {

constexpr double kOpening = 20;  // metres, the width of objects that are no ground
constexpr double kOpeningSquare = 0.5;
constexpr double kObjectHeight = 0.4;  // above the opening
constexpr double kKeepAway = 0.5;      // blurred texels beside holes and objects
constexpr double kLeastRegion = 4;     // square metres
constexpr double kWaterBand = 0.6;
constexpr double kBeside = 3;      // metres: the surface that a fill goes on from
constexpr double kBlurred = 0.25;  // metres: texels at the end of the surface

// The best value within `reach` of each square, along one axis and then the other.
template <typename Better>
std::vector<float> BestWithin(const std::vector<float>& values, int32_t width, int32_t height, int32_t reach,
                              const Better& better) {
  std::vector<float> along(values.size()), result(values.size());
  const auto at = [&](int32_t x, int32_t y) {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  };
  for (int32_t y = 0; y < height; ++y) {
    for (int32_t x = 0; x < width; ++x) {
      float best = values[at(x, y)];
      for (int32_t k = std::max(0, x - reach); k <= std::min(width - 1, x + reach); ++k)
        best = better(best, values[at(k, y)]);
      along[at(x, y)] = best;
    }
  }
  for (int32_t y = 0; y < height; ++y) {
    for (int32_t x = 0; x < width; ++x) {
      float best = along[at(x, y)];
      for (int32_t k = std::max(0, y - reach); k <= std::min(height - 1, y + reach); ++k)
        best = better(best, along[at(x, k)]);
      result[at(x, y)] = best;
    }
  }
  return result;
}

// The opened surface by squares of the lattice.
std::vector<float> Opened(const OrthoRaster& raster, const SquareLattice& squares) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  std::vector<float> lowest(squares.values.size(), kNone);
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const float height = raster.heights[raster.frame.At(x, y)];
      float& low = lowest[SquareOf(squares, raster.frame, x, y)];
      if (height != kNoSurface) low = std::min(low, height);
    }
  }
  const auto reach = static_cast<int32_t>(std::ceil(kOpening / 2 / (squares.pixels * raster.frame.texel)));
  std::vector<float> eroded =
      BestWithin(lowest, squares.width, squares.height, reach, [](float a, float b) { return std::min(a, b); });
  for (float& value : eroded) value = value == kNone ? kNoSurface : value;
  return BestWithin(eroded, squares.width, squares.height, reach, [](float a, float b) { return std::max(a, b); });
}

}  // namespace

int32_t PixelsIn(double metres, const RasterFrame& frame) {
  return std::max(1, static_cast<int32_t>(std::lround(metres / frame.texel)));
}

PixelMask Dilated(const PixelMask& mask, const RasterFrame& frame, int32_t radius) {
  PixelMask along(mask.size()), result(mask.size());
  const auto pass = [radius](const PixelMask& from, PixelMask& to, size_t first, size_t step, int32_t count) {
    int32_t last = -radius - 1;
    for (int32_t i = 0; i < count + radius; ++i) {
      if (i < count && from[first + static_cast<size_t>(i) * step] != 0) last = i;
      const int32_t here = i - radius;  // all up to here + radius have been seen
      if (here >= 0 && last >= here - radius) to[first + static_cast<size_t>(here) * step] = 1;
    }
  };
  const auto width = static_cast<size_t>(frame.width);
  for (int32_t y = 0; y < frame.height; ++y) pass(mask, along, frame.At(0, y), 1, frame.width);
  for (int32_t x = 0; x < frame.width; ++x) pass(along, result, frame.At(x, 0), width, frame.height);
  return result;
}

void DropSmallRegions(const RasterFrame& frame, int64_t least, PixelMask& mask) {
  PixelMask seen(mask.size());
  std::vector<size_t> region;
  const auto visit = [&](size_t at) {
    if (mask[at] == 0 || seen[at] != 0) return;
    seen[at] = 1;
    region.push_back(at);
  };
  const auto width = static_cast<size_t>(frame.width);
  for (size_t start = 0; start < mask.size(); ++start) {
    region.clear();
    visit(start);
    for (size_t next = 0; next < region.size(); ++next) {
      const size_t at = region[next];
      if (at % width > 0) visit(at - 1);
      if (at % width + 1 < width) visit(at + 1);
      if (at >= width) visit(at - width);
      if (at + width < mask.size()) visit(at + width);
    }
    if (static_cast<int64_t>(region.size()) >= least) continue;
    for (const size_t at : region) mask[at] = 0;
  }
}

PixelMask GroundPixels(const OrthoRaster& raster, std::span<const FillPixel> fill) {
  const SquareLattice squares = LatticeOver(raster.frame, kOpeningSquare);
  const std::vector<float> opened = Opened(raster, squares);
  PixelMask blocked(raster.known.size());
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      const float above = raster.heights[at] - opened[SquareOf(squares, raster.frame, x, y)];
      const bool is_ground = raster.known[at] != 0 && fill[at] == FillPixel::kNone && above < kObjectHeight;
      blocked[at] = is_ground ? 0 : 1;
    }
  }
  PixelMask ground = Dilated(blocked, raster.frame, PixelsIn(kKeepAway, raster.frame));
  for (uint8_t& value : ground) value = value == 0 ? 1 : 0;
  DropSmallRegions(raster.frame, std::lround(kLeastRegion / (raster.frame.texel * raster.frame.texel)), ground);
  return ground;
}

PixelMask SurfaceBeside(const OrthoRaster& raster, std::span<const FillPixel> fill, const SquareLattice& level) {
  const RasterFrame& frame = raster.frame;
  PixelMask filled(fill.size()), objects(fill.size());
  for (size_t i = 0; i < filled.size(); ++i) filled[i] = fill[i] != FillPixel::kNone ? 1 : 0;
  PixelMask beside = Dilated(filled, frame, PixelsIn(kBeside, frame));
  for (int32_t y = 0; y < frame.height; ++y) {
    for (int32_t x = 0; x < frame.width; ++x) {
      const size_t at = frame.At(x, y);
      if (beside[at] == 0 || raster.known[at] == 0) continue;
      const double above = double{raster.heights[at]} - double{ValueAt(level, frame, x, y)[0]};
      objects[at] = above >= kObjectHeight ? 1 : 0;
      if (above <= -kObjectHeight) beside[at] = 0;
    }
  }
  const PixelMask at_end = Dilated(filled, frame, PixelsIn(kBlurred, frame)),
                  at_object = Dilated(objects, frame, PixelsIn(kKeepAway, frame));
  for (size_t i = 0; i < beside.size(); ++i) {
    if (at_end[i] != 0 || at_object[i] != 0 || raster.known[i] == 0) beside[i] = 0;
  }
  return beside;
}

PixelMask WaterPixels(const OrthoRaster& raster, std::span<const FillPixel> fill, double level) {
  PixelMask filled(raster.known.size());
  for (size_t i = 0; i < filled.size(); ++i) filled[i] = fill[i] != FillPixel::kNone ? 1 : 0;
  PixelMask water = Dilated(filled, raster.frame, 1);
  for (size_t i = 0; i < water.size(); ++i) {
    const bool is_level = std::abs(static_cast<double>(raster.heights[i]) - level) <= kWaterBand;
    water[i] = water[i] == 0 && raster.known[i] != 0 && is_level ? 1 : 0;
  }
  return water;
}

}  // namespace tilemend
