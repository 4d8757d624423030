#include "worker/texture/synthesize.h"

#include <algorithm>
#include <cmath>

#include "worker/texture/base_colours.h"
#include "worker/texture/grain.h"
#include "worker/texture/pixel_masks.h"
#include "worker/texture/square_lattice.h"
#include "worker/texture/streamlines.h"

namespace tilemend {
namespace {

constexpr double kRimBand = 1.2;  // metres of sources beside the fill in which the step is measured
constexpr double kRimSmooth = 0.6;
constexpr double kRimFade = 2;
constexpr float kMostStep = 40;      // grey levels; more is an object, a mark or a shadow
constexpr double kLevelSquare = 1;   // metres
constexpr float kMostAboveFill = 1;  // metres, or below
constexpr double kWaterGrain = 1.5;  // grey levels
constexpr int kRimSweeps = 30;

// One layer of a fill while it is made.
class LayerMaker {
 public:
  LayerMaker(const OrthoRaster& raster, const FillMap& fill, FillPixel layer)
      : raster_(raster), frame_(raster.frame), fill_(fill), make_(fill.pixels.size()), hole_(make_.size()) {
    for (size_t i = 0; i < make_.size(); ++i) {
      make_[i] = fill.pixels[i] == layer ? 1 : 0;
      hole_[i] = fill.pixels[i] != FillPixel::kNone ? 1 : 0;
    }
    rim_ = Dilated(make_, frame_, std::max(2, PixelsIn(kRimBand, frame_)));
  }

  bool IsNeeded() const { return std::find(make_.begin(), make_.end(), 1) != make_.end(); }

  void Ground(PixelMask sources, Rgb fallback) {
    const SquareLattice level = LevelOfFill();
    beside_ = SurfaceBeside(raster_, fill_.pixels, level);
    SetBase(fallback);
    KeepFillHeight(level, sources);
    const bool has_sources = std::find(sources.begin(), sources.end(), 1) != sources.end();
    if (has_sources) {
      DropShadows(raster_, sources);
      CarryStructure(raster_, sources, StructureOf(raster_, sources), MadeAndRim(sources), colours_);
    }
    SpreadRimStep();
    if (has_sources) AddGrain(raster_, sources, make_, colours_);
  }

  void Water(const PixelMask& sources, const FillLook& look) {
    if (look.given_water) {
      colours_.assign(make_.size(), ChannelsOf(*look.given_water));
    } else {
      beside_ = Dilated(hole_, frame_, PixelsIn(kRimBand, frame_));
      for (size_t i = 0; i < sources.size(); ++i) beside_[i] = beside_[i] != 0 && sources[i] != 0 ? 1 : 0;
      colours_.assign(make_.size(), ChannelsOf(look.water));  // one for the whole body, in all cells
      SpreadRimStep();
    }
    ForEachMade([&](int32_t x, int32_t y, size_t at) {
      const float white = WhiteGrain(frame_.column + x, frame_.row + y, kWaterGrain);
      for (float& value : colours_[at]) value += white;
    });
  }

  void Write(std::vector<Rgb>& out) const {
    const auto rounded = [](float value) { return static_cast<uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F)); };
    for (size_t i = 0; i < out.size(); ++i) {
      if (make_[i] == 0) continue;
      const Channels& c = colours_[i];
      out[i] = {rounded(c[0]), rounded(c[1]), rounded(c[2])};
    }
  }

 private:
  template <typename Use>
  void ForEachMade(const Use& use) const {
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        if (const size_t at = frame_.At(x, y); make_[at] != 0) use(x, y, at);
      }
    }
  }

  // The colour of most of the rim near by; the fallback if the rim has no source.
  void SetBase(Rgb fallback) {
    const SquareLattice squares = MedianSquares(raster_, beside_);
    const bool is_known = std::any_of(squares.weights.begin(), squares.weights.end(), [](float w) { return w > 0; });
    colours_.assign(make_.size(), ChannelsOf(fallback));
    if (!is_known) return;
    const SquareLattice middles = MiddlesNear(frame_, squares, rim_);
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        if (const size_t at = frame_.At(x, y); rim_[at] != 0) colours_[at] = ValueAt(middles, frame_, x, y);
      }
    }
  }

  // How high the fill is, and would be beside it.
  SquareLattice LevelOfFill() const {
    SquareLattice level = LatticeOver(frame_, kLevelSquare);
    ForEachMade([&](int32_t x, int32_t y, size_t at) {
      const size_t square = SquareOf(level, frame_, x, y);
      level.values[square][0] += fill_.heights[at];
      level.weights[square] += 1;
    });
    for (size_t i = 0; i < level.values.size(); ++i) level.values[i][0] /= std::max(1.0F, level.weights[i]);
    FillSquares(level);
    return level;
  }

  // Takes out sources on other levels than the fill beside them: terraces, a street above a bank.
  void KeepFillHeight(const SquareLattice& level, PixelMask& sources) const {
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        if (sources[at] == 0) continue;
        const float above = raster_.heights[at] - ValueAt(level, frame_, x, y)[0];
        if (std::abs(above) > kMostAboveFill) sources[at] = 0;
      }
    }
  }

  PixelMask MadeAndRim(const PixelMask& sources) const {
    PixelMask mask = make_;
    for (size_t i = 0; i < mask.size(); ++i) {
      if (rim_[i] != 0 && sources[i] != 0) mask[i] = 1;
    }
    return mask;
  }

  // What the surface beside the fill differs from what was made there, spread over the fill.
  void SpreadRimStep() {
    SquareLattice step = LatticeOver(frame_, kRimSmooth);
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        if (rim_[at] == 0 || beside_[at] == 0) continue;
        const size_t square = SquareOf(step, frame_, x, y);
        const Channels seen = ChannelsOf(raster_.colours[at]);
        if (std::abs(Brightness(seen) - Brightness(colours_[at])) > kMostStep) continue;
        for (size_t c = 0; c < 3; ++c) step.values[square][c] += seen[c] - colours_[at][c];
        step.weights[square] += 1;
      }
    }
    for (size_t i = 0; i < step.values.size(); ++i) {
      for (float& value : step.values[i]) value /= std::max(1.0F, step.weights[i]);
      step.weights[i] = std::min(step.weights[i], 1.0F);
    }
    SmoothSquares(kRimSmooth / (step.pixels * frame_.texel), step);
    FadeSquares(kRimFade / (step.pixels * frame_.texel), kRimSweeps, step);
    ForEachMade([&](int32_t x, int32_t y, size_t at) {
      const Channels value = ValueAt(step, frame_, x, y);
      for (size_t c = 0; c < 3; ++c) colours_[at][c] += value[c];
    });
  }

  const OrthoRaster& raster_;
  const RasterFrame& frame_;
  const FillMap& fill_;
  PixelMask make_, hole_, rim_, beside_;
  std::vector<Channels> colours_;
};

// Gives the pixels of a line that have no colour that of the nearest one that has. Then they have one.
void ExtendLine(size_t first, size_t step, int32_t count, PixelMask& known, std::vector<Rgb>& colours) {
  const auto at = [&](int32_t i) { return first + static_cast<size_t>(i) * step; };
  std::vector<int32_t> nearest(static_cast<size_t>(count), -1);
  for (int32_t i = 0, last = -1; i < count; ++i) {
    if (known[at(i)] != 0) last = i;
    nearest[static_cast<size_t>(i)] = last;
  }
  for (int32_t i = count - 1, next = -1; i >= 0; --i) {
    if (known[at(i)] != 0) next = i;
    int32_t& from = nearest[static_cast<size_t>(i)];
    if (next >= 0 && (from < 0 || next - i < i - from)) from = next;
  }
  for (int32_t i = 0; i < count; ++i) {
    const int32_t from = nearest[static_cast<size_t>(i)];
    if (from < 0) return;
    colours[at(i)] = colours[at(from)];
  }
  for (int32_t i = 0; i < count; ++i) known[at(i)] = 1;
}

// Pixels without surface or fill get a colour, too: texels at the end of a cell's fill are blended with them.
void CoverBarePixels(const OrthoRaster& raster, const FillMap& fill, std::vector<Rgb>& colours) {
  const RasterFrame& frame = raster.frame;
  PixelMask known(colours.size());
  for (size_t i = 0; i < known.size(); ++i) {
    const bool is_made = fill.pixels[i] == FillPixel::kGround || fill.pixels[i] == FillPixel::kWater;
    known[i] = is_made || raster.heights[i] != kNoSurface ? 1 : 0;
  }
  for (int32_t y = 0; y < frame.height; ++y) ExtendLine(frame.At(0, y), 1, frame.width, known, colours);
  const auto width = static_cast<size_t>(frame.width);
  for (int32_t x = 0; x < frame.width; ++x) ExtendLine(frame.At(x, 0), width, frame.height, known, colours);
}

}  // namespace

std::vector<Rgb> Synthesize(const OrthoRaster& raster, const FillMap& fill, const FillLook& look) {
  std::vector<Rgb> result = raster.colours;
  if (LayerMaker ground(raster, fill, FillPixel::kGround); ground.IsNeeded()) {
    ground.Ground(GroundPixels(raster, fill.pixels), look.ground);
    ground.Write(result);
  }
  if (LayerMaker water(raster, fill, FillPixel::kWater); water.IsNeeded()) {
    water.Water(WaterPixels(raster, fill.pixels, look.water_level), look);
    water.Write(result);
  }
  CoverBarePixels(raster, fill, result);
  return result;
}

}  // namespace tilemend
