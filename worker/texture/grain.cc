#include "worker/texture/grain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "worker/texture/base_colours.h"

namespace tilemend {
namespace {

constexpr double kWindow = 2, kWindowStep = 0.5;  // metres
constexpr int32_t kMostWindow = 16;               // pixels: the cost of a pixel is this squared
constexpr double kLow = 1;                        // metres: slower changes are no grain
constexpr uint32_t kSpots = 4;
constexpr double kPlain = 1.25;      // deviation of a window without marks, in that of the plainest quarter
constexpr double kWhiteSigma = 1.5;  // grey levels, where nothing tells it
constexpr double kMostSigma = 8;

using Grain = std::array<float, 3>;

int64_t FloorOf(int64_t a, int64_t b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

struct Window {
  int32_t x = 0, y = 0;
};

// Sums over rectangles in constant time.
class SumTable {
 public:
  explicit SumTable(const RasterFrame& frame)
      : width_(frame.width + 1),
        sums_((static_cast<size_t>(frame.width) + 1) * (static_cast<size_t>(frame.height) + 1)) {}
  // In the order of the rows.
  void Set(int32_t x, int32_t y, int64_t value) {
    sums_[At(x + 1, y + 1)] = value + sums_[At(x, y + 1)] + sums_[At(x + 1, y)] - sums_[At(x, y)];
  }
  int64_t Of(const Window& w, int32_t side) const {
    return sums_[At(w.x + side, w.y + side)] - sums_[At(w.x, w.y + side)] - sums_[At(w.x + side, w.y)] +
           sums_[At(w.x, w.y)];
  }

 private:
  size_t At(int32_t x, int32_t y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }
  int32_t width_;
  std::vector<int64_t> sums_;
};

// The grain of sources: what is left of their colour without the low frequencies.
std::vector<Grain> GrainOf(const OrthoRaster& raster, const PixelMask& sources) {
  SquareLattice low = MedianSquares(raster, sources);
  SmoothSquares(kLow / (low.pixels * raster.frame.texel), low);
  FillSquares(low);
  std::vector<Grain> grain(sources.size());
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      if (sources[at] == 0) continue;
      const Channels here = ChannelsOf(raster.colours[at]), mean = ValueAt(low, raster.frame, x, y);
      for (size_t c = 0; c < 3; ++c) grain[at][c] = here[c] - mean[c];
    }
  }
  return grain;
}

// Noise with the colours and the spectrum of windows of the sources.
class SpotNoise {
 public:
  SpotNoise(const OrthoRaster& raster, const PixelMask& sources)
      : frame_(raster.frame),
        side_(std::clamp(static_cast<int32_t>(std::lround(kWindow / frame_.texel)), 4, kMostWindow)),
        grain_(GrainOf(raster, sources)) {
    FindWindows(sources);
    TakeSpots();
  }

  void AddTo(const PixelMask& make, std::vector<Channels>& colours) const {
    for (size_t k = 0; k < spots_.size(); ++k) AddSpot(static_cast<uint32_t>(k), make, colours);
    if (!spots_.empty()) return;
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        if (make[at] == 0) continue;
        const float white = WhiteGrain(frame_.column + x, frame_.row + y, sigma_);
        for (float& value : colours[at]) value += white;
      }
    }
  }

 private:
  void FindWindows(const PixelMask& sources) {
    SumTable known(frame_), squares(frame_);
    int64_t all = 0;
    double sum = 0;
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        const auto grey =
            static_cast<int64_t>(std::lround(grain_[at][0] + 2 * grain_[at][1] + grain_[at][2])) * sources[at];
        known.Set(x, y, sources[at]);
        squares.Set(x, y, grey * grey);
        all += sources[at];
        sum += static_cast<double>(grey * grey);
      }
    }
    if (all > 0) sigma_ = std::min(kMostSigma, std::sqrt(sum / static_cast<double>(all)) / 4);
    std::vector<std::pair<int64_t, Window>> found;
    const auto step = std::max<int64_t>(1, std::lround(kWindowStep / frame_.texel));
    for (int64_t y = (FloorOf(frame_.row, step) + 1) * step - frame_.row; y + side_ <= frame_.height; y += step) {
      for (int64_t x = (FloorOf(frame_.column, step) + 1) * step - frame_.column; x + side_ <= frame_.width;
           x += step) {
        const Window w{static_cast<int32_t>(x), static_cast<int32_t>(y)};
        if (known.Of(w, side_) == int64_t{side_} * side_) found.emplace_back(squares.Of(w, side_), w);
      }
    }
    if (found.empty()) return;
    std::vector<int64_t> deviations;
    for (const auto& [deviation, w] : found) deviations.push_back(deviation);
    const auto quarter = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 4);
    std::nth_element(deviations.begin(), quarter, deviations.end());
    const double most = static_cast<double>(*quarter) * kPlain * kPlain;
    for (const auto& [deviation, w] : found) {
      if (static_cast<double>(deviation) <= most) windows_.push_back(w);
    }
  }

  // Windows chosen by a hash, less their means, so scaled that the sum of all noises has the windows' deviation.
  void TakeSpots() {
    if (windows_.empty()) return;
    const float scale = 1 / std::sqrt(static_cast<float>(kSpots) * static_cast<float>(side_ * side_));
    for (uint32_t k = 0; k < kSpots; ++k) {
      const Window& w = windows_[HashOfPlace(k, 0, 0x73706f74U) % windows_.size()];
      std::vector<Grain>& spot = spots_.emplace_back();
      Grain mean{};
      for (int32_t y = 0; y < side_; ++y) {
        for (int32_t x = 0; x < side_; ++x) {
          spot.push_back(grain_[frame_.At(w.x + x, w.y + y)]);
          for (size_t c = 0; c < 3; ++c) mean[c] += spot.back()[c] / static_cast<float>(side_ * side_);
        }
      }
      for (Grain& g : spot) {
        for (size_t c = 0; c < 3; ++c) g[c] = scale * (g[c] - mean[c]);
      }
    }
  }

  // The spot at every pixel of the lattice, with a random sign.
  void AddSpot(uint32_t k, const PixelMask& make, std::vector<Channels>& colours) const {
    const int32_t width = frame_.width + side_;
    std::vector<float> white(static_cast<size_t>(width) * static_cast<size_t>(frame_.height + side_));
    for (int32_t y = 0; y < frame_.height + side_; ++y) {
      for (int32_t x = 0; x < width; ++x) {
        const bool is_up = (HashOfPlace(frame_.column + x, frame_.row + y, k) & 1) != 0;
        white[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] = is_up ? 1.0F : -1.0F;
      }
    }
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        if (make[at] == 0) continue;
        Channels sum{};
        const Grain* spot = spots_[k].data();
        for (int32_t dy = 0; dy < side_; ++dy) {
          const float* row = &white[static_cast<size_t>(y + dy) * static_cast<size_t>(width) + static_cast<size_t>(x)];
          for (int32_t dx = 0; dx < side_; ++dx, ++spot) {
            for (size_t c = 0; c < 3; ++c) sum[c] += row[dx] * (*spot)[c];
          }
        }
        for (size_t c = 0; c < 3; ++c) colours[at][c] += sum[c];
      }
    }
  }

  const RasterFrame& frame_;
  const int32_t side_;  // pixels
  double sigma_ = kWhiteSigma;
  std::vector<Grain> grain_;  // of the sources
  std::vector<Window> windows_;
  std::vector<std::vector<Grain>> spots_;
};

}  // namespace

uint32_t HashOfPlace(int64_t x, int64_t y, uint32_t purpose) {
  // The mixer of SplitMix64 (Steele, Lea and Flood 2014).
  uint64_t h = static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15U;
  h ^= (static_cast<uint64_t>(y) + 0x7f4a7c15U) * 0xbf58476d1ce4e5b9U;
  h += uint64_t{purpose} * 0x94d049bb133111ebU;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
  return static_cast<uint32_t>((h ^ (h >> 31)) >> 16);
}

float WhiteGrain(int64_t column, int64_t row, double sigma) {
  constexpr double kSide = 0.4578, kCorner = 0.2096;  // exp(-d^2 / (2 * 0.8^2))
  // Of the sum of two uniform numbers in -0.5 to 0.5, and of the kernel.
  const double deviation = std::sqrt((1 + 4 * kSide * kSide + 4 * kCorner * kCorner) / 6);
  double sum = 0;
  for (int64_t dy = -1; dy <= 1; ++dy) {
    for (int64_t dx = -1; dx <= 1; ++dx) {
      const uint32_t hash = HashOfPlace(column + dx, row + dy, 0x77686974U);
      const double value = (static_cast<double>(hash & 0xffffU) + static_cast<double>(hash >> 16)) / 65535 - 1;
      sum += value * (dx == 0 && dy == 0 ? 1 : dx == 0 || dy == 0 ? kSide : kCorner);
    }
  }
  return static_cast<float>(sigma * sum / deviation);
}

void AddGrain(const OrthoRaster& raster, const PixelMask& sources, const PixelMask& make,
              std::vector<Channels>& colours) {
  PixelMask textured = sources;
  for (size_t i = 0; i < textured.size(); ++i) textured[i] = raster.known[i] == kPlainColour ? 0 : sources[i];
  const auto has_pixels = [](const PixelMask& mask) { return std::find(mask.begin(), mask.end(), 1) != mask.end(); };
  if (has_pixels(sources) && !has_pixels(textured)) return;
  SpotNoise(raster, textured).AddTo(make, colours);
}

}  // namespace tilemend
