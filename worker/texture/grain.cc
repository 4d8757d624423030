#include "worker/texture/grain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "worker/texture/base_colours.h"

namespace tilemend {
namespace {

constexpr double kBlock = 4, kOverlap = 1.2, kWindowStep = 0.5;  // metres
constexpr int kCandidates = 40;
constexpr double kPlain = 1.25;      // deviation of a window without marks, in that of the plainest quarter
constexpr double kWhiteSigma = 1.5;  // grey levels, where nothing tells it
constexpr double kMostSigma = 8;

using Grain = std::array<int8_t, 3>;

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
  FillSquares(low);
  std::vector<Grain> grain(sources.size());
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      if (sources[at] == 0) continue;
      const Channels here = ChannelsOf(raster.colours[at]), mean = ValueAt(low, raster.frame, x, y);
      for (size_t c = 0; c < 3; ++c)
        grain[at][c] = static_cast<int8_t>(std::clamp(std::round(here[c] - mean[c]), -127.0F, 127.0F));
    }
  }
  return grain;
}

class Quilt {
 public:
  Quilt(const OrthoRaster& raster, const PixelMask& sources)
      : frame_(raster.frame),
        side_(std::max(4, static_cast<int32_t>(std::lround(kBlock / frame_.texel)))),
        overlap_(std::max(1, static_cast<int32_t>(std::lround(kOverlap / frame_.texel)))),
        grain_(GrainOf(raster, sources)),
        made_(sources.size()),
        placed_(sources.size()) {
    FindWindows(sources);
  }

  // Lays all blocks that meet `make`, from south-west to north-east.
  void Lay(const PixelMask& make) {
    const int64_t stride = side_ - overlap_;
    const int64_t last_row = FloorOf(frame_.row + frame_.height - 1, stride),
                  last_column = FloorOf(frame_.column + frame_.width - 1, stride);
    for (int64_t j = FloorOf(frame_.row - side_, stride); j <= last_row; ++j) {
      for (int64_t i = FloorOf(frame_.column - side_, stride); i <= last_column; ++i) {
        const Window block{static_cast<int32_t>(i * stride - frame_.column),
                           static_cast<int32_t>(j * stride - frame_.row)};
        if (!windows_.empty() && Meets(make, block)) LayBlock(i, j, block);
      }
    }
  }

  void AddAt(int32_t x, int32_t y, Channels& colour) const {
    const size_t at = frame_.At(x, y);
    if (placed_[at] == 0) {
      const float white = WhiteGrain(frame_.column + x, frame_.row + y, sigma_);
      for (float& value : colour) value += white;
      return;
    }
    for (size_t c = 0; c < 3; ++c) colour[c] += made_[at][c];
  }

 private:
  void FindWindows(const PixelMask& sources) {
    SumTable known(frame_), squares(frame_);
    int64_t all = 0;
    double sum = 0;
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        const size_t at = frame_.At(x, y);
        const int64_t grey = (int64_t{grain_[at][0]} + 2 * grain_[at][1] + grain_[at][2]) * sources[at];
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

  bool Meets(const PixelMask& make, const Window& block) const {
    for (int32_t y = std::max(0, block.y); y < std::min(frame_.height, block.y + side_); ++y) {
      for (int32_t x = std::max(0, block.x); x < std::min(frame_.width, block.x + side_); ++x) {
        if (make[frame_.At(x, y)] != 0) return true;
      }
    }
    return false;
  }

  // The squared difference to what is placed, at a pixel of the block; 0 where nothing is.
  int32_t DifferenceAt(const Window& block, const Window& from, int32_t x, int32_t y) const {
    if (!frame_.Has(block.x + x, block.y + y)) return 0;
    const size_t old = frame_.At(block.x + x, block.y + y);
    if (placed_[old] == 0) return 0;
    const size_t fresh = frame_.At(from.x + x, from.y + y);
    int32_t sum = 0;
    for (size_t c = 0; c < 3; ++c) {
      const int32_t d = int32_t{made_[old][c]} - grain_[fresh][c];
      sum += d * d;
    }
    return sum;
  }

  // In the overlaps at the left and the bottom alone.
  int64_t Misfit(const Window& block, const Window& from) const {
    int64_t sum = 0;
    for (int32_t y = 0; y < side_; ++y) {
      const int32_t end = y < overlap_ ? side_ : overlap_;
      for (int32_t x = 0; x < end; ++x) sum += DifferenceAt(block, from, x, y);
    }
    return sum;
  }

  // The cheapest cut through an overlap: for each of `side_` lines the place of the cut. `cost(line, place)`.
  template <typename Cost>
  std::vector<int32_t> Cut(const Cost& cost) const {
    const auto width = static_cast<size_t>(overlap_);
    std::vector<int64_t> sums(width * static_cast<size_t>(side_));
    const auto best_before = [&](int32_t line, int32_t place) {
      int32_t best = place;
      for (int32_t k = std::max(0, place - 1); k <= std::min(overlap_ - 1, place + 1); ++k) {
        const size_t before = static_cast<size_t>(line - 1) * width;
        if (sums[before + static_cast<size_t>(k)] < sums[before + static_cast<size_t>(best)]) best = k;
      }
      return best;
    };
    for (int32_t line = 0; line < side_; ++line) {
      for (int32_t place = 0; place < overlap_; ++place) {
        int64_t& sum = sums[static_cast<size_t>(line) * width + static_cast<size_t>(place)];
        sum = cost(line, place);
        if (line > 0)
          sum += sums[static_cast<size_t>(line - 1) * width + static_cast<size_t>(best_before(line, place))];
      }
    }
    const auto last = sums.end() - overlap_;
    std::vector<int32_t> cut(static_cast<size_t>(side_));
    cut.back() = static_cast<int32_t>(std::min_element(last, sums.end()) - last);
    for (int32_t line = side_ - 1; line > 0; --line) {
      cut[static_cast<size_t>(line - 1)] = best_before(line, cut[static_cast<size_t>(line)]);
    }
    return cut;
  }

  void LayBlock(int64_t i, int64_t j, const Window& block) {
    Window best{};
    int64_t least = std::numeric_limits<int64_t>::max();
    for (uint32_t k = 0; k < kCandidates; ++k) {
      const Window& w = windows_[HashOfPlace(i, j, k) % windows_.size()];
      const int64_t misfit = Misfit(block, w);
      if (misfit < least) {
        least = misfit;
        best = w;
      }
    }
    const std::vector<int32_t> left = Cut([&](int32_t y, int32_t x) { return DifferenceAt(block, best, x, y); });
    const std::vector<int32_t> bottom = Cut([&](int32_t x, int32_t y) { return DifferenceAt(block, best, x, y); });
    for (int32_t y = 0; y < side_; ++y) {
      for (int32_t x = 0; x < side_; ++x) {
        if (!frame_.Has(block.x + x, block.y + y)) continue;
        const size_t at = frame_.At(block.x + x, block.y + y);
        const bool before_cut = x < left[static_cast<size_t>(y)] || y < bottom[static_cast<size_t>(x)];
        if (placed_[at] != 0 && before_cut) continue;
        made_[at] = grain_[frame_.At(best.x + x, best.y + y)];
        placed_[at] = 1;
      }
    }
  }

  const RasterFrame& frame_;
  const int32_t side_, overlap_;  // pixels
  double sigma_ = kWhiteSigma;
  std::vector<Grain> grain_;  // of the sources
  std::vector<Grain> made_;
  PixelMask placed_;
  std::vector<Window> windows_;
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
  Quilt quilt(raster, sources);
  quilt.Lay(make);
  for (int32_t y = 0; y < raster.frame.height; ++y) {
    for (int32_t x = 0; x < raster.frame.width; ++x) {
      const size_t at = raster.frame.At(x, y);
      if (make[at] != 0) quilt.AddAt(x, y, colours[at]);
    }
  }
}

}  // namespace tilemend
