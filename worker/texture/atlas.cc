#include "worker/texture/atlas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace tilemend {
namespace {

constexpr int32_t kMostSide = 8192;
constexpr int32_t kLeastSide = 8;
constexpr int32_t kSteepSide = 8;  // pixels, as the blocks of a JPEG
// The squares of steep triangles take at most half of the largest image.
constexpr size_t kMostSquares = size_t{kMostSide} * kMostSide / (kSteepSide * kSteepSide) / 2;

// A rectangle of the image.
struct Part {
  int32_t x = 0, y = 0;  // in the source, pixels
  int32_t width = 0, height = 0;
  int32_t to_x = 0, to_y = 0;  // in the image, from its lower left corner
};

int32_t PowerOfTwo(int64_t value) {
  int32_t power = kLeastSide;
  while (power < value) power *= 2;
  return power;
}

// Puts parts on shelves, the highest first; the height of them all.
int64_t Shelve(const std::vector<size_t>& order, int32_t width, std::vector<Part>& parts) {
  int64_t x = 0, y = 0, shelf = 0;
  for (const size_t i : order) {
    Part& part = parts[i];
    if (x + part.width > width) {
      y += shelf;
      x = shelf = 0;
    }
    part.to_x = static_cast<int32_t>(x);
    part.to_y = static_cast<int32_t>(std::min<int64_t>(y, kMostSide));
    x += part.width;
    shelf = std::max<int64_t>(shelf, part.height);
  }
  return y + shelf;
}

// The sides of the smallest image; {0, 0} if none is large enough.
std::pair<int32_t, int32_t> Pack(std::vector<Part>& parts) {
  std::vector<size_t> order(parts.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return parts[a].height > parts[b].height; });
  int32_t widest = 1;
  for (const Part& part : parts) widest = std::max(widest, part.width);
  std::pair<int32_t, int32_t> best{0, 0};
  int64_t least = std::numeric_limits<int64_t>::max();
  for (int64_t width = PowerOfTwo(widest); width <= kMostSide; width *= 2) {
    const int64_t used = Shelve(order, static_cast<int32_t>(width), parts);
    if (used > kMostSide) continue;
    const int32_t height = PowerOfTwo(used);
    if (width * height >= least) continue;
    least = width * height;
    best = {static_cast<int32_t>(width), height};
  }
  if (best.first > 0) Shelve(order, best.first, parts);
  return best;
}

class AtlasPacker {
 public:
  AtlasPacker(const AtlasFaces& faces, std::span<const MadeRaster> rasters) : faces_(faces), rasters_(rasters) {}

  Atlas Pack() {
    ShareSquares();
    for (scale_ = 1;; scale_ *= 2) {
      SetParts();
      const auto [width, height] = tilemend::Pack(parts_);
      if (width == 0) continue;
      atlas_.image = {width, height, 3, {}};
      break;
    }
    FillWithMean();
    for (size_t i = 0; i < rasters_.size(); ++i) CopyPart(parts_[i], rasters_[i]);
    for (const SquareColours& colours : squares_) DrawSquare(colours);
    for (size_t t = 0; t < faces_.triangles.size(); ++t) {
      atlas_.corners.push_back(faces_.rasters[t] < 0 ? SteepCorners(t) : FlatCorners(t));
    }
    return std::move(atlas_);
  }

 private:
  using SquareColours = std::array<Rgb, 3>;

  // Gives the steep triangles of equal colours one square. If that leaves too many, it drops bits of the colours: 6
  // bits less leave 4^9 squares at most.
  void ShareSquares() {
    for (int bits = 0; !TryShareSquares(bits); ++bits) {
    }
  }

  // False if there are more than kMostSquares.
  bool TryShareSquares(int dropped_bits) {
    const auto rounded = [&](uint8_t value) {
      const int middle = (1 << dropped_bits) >> 1;
      return static_cast<uint8_t>((value >> dropped_bits << dropped_bits) + middle);
    };
    std::map<std::array<uint8_t, 9>, int32_t> numbers;
    squares_.clear();
    square_of_.assign(faces_.triangles.size(), -1);
    for (size_t t = 0; t < faces_.triangles.size(); ++t) {
      if (faces_.rasters[t] >= 0) continue;
      SquareColours colours;
      std::array<uint8_t, 9> key{};
      for (size_t k = 0; k < 3; ++k) {
        const Rgb c = faces_.steep_colours[3 * t + k];
        colours[k] = {rounded(c.r), rounded(c.g), rounded(c.b)};
        key[3 * k] = colours[k].r;
        key[3 * k + 1] = colours[k].g;
        key[3 * k + 2] = colours[k].b;
      }
      const auto [at, is_new] = numbers.try_emplace(key, static_cast<int32_t>(squares_.size()));
      if (is_new && squares_.size() == kMostSquares) return false;
      if (is_new) squares_.push_back(colours);
      square_of_[t] = at->second;
    }
    return true;
  }

  // The pixels of each raster that its triangles need, with a gutter, and a square of squares for the steep ones.
  void SetParts() {
    std::vector<Eigen::AlignedBox2d> boxes(rasters_.size());
    for (size_t t = 0; t < faces_.triangles.size(); ++t) {
      const int32_t raster = faces_.rasters[t];
      if (raster < 0) continue;
      for (const int32_t v : faces_.triangles[t]) boxes[static_cast<size_t>(raster)].extend(PixelsAt(v, raster));
    }
    parts_.assign(rasters_.size() + 1, {});
    for (size_t i = 0; i < rasters_.size(); ++i) {
      if (boxes[i].isEmpty()) continue;
      const RasterFrame& frame = rasters_[i].frame;
      const auto lo = [](double p) { return static_cast<int32_t>(std::max(0.0, std::floor(p) - kAtlasGutter)); };
      const auto hi = [](double p, int32_t most) {
        return static_cast<int32_t>(std::min<double>(most, std::ceil(p) + kAtlasGutter));
      };
      Part& part = parts_[i];
      part.x = std::min(lo(boxes[i].min().x()), frame.width - 1);
      part.y = std::min(lo(boxes[i].min().y()), frame.height - 1);
      part.width = Scaled(std::max(hi(boxes[i].max().x(), frame.width) - part.x, 1));
      part.height = Scaled(std::max(hi(boxes[i].max().y(), frame.height) - part.y, 1));
    }
    const auto squares = static_cast<int32_t>(squares_.size());
    if (squares == 0) return;
    while (steep_columns_ * steep_columns_ < squares) ++steep_columns_;
    parts_.back().width = steep_columns_ * kSteepSide;
    parts_.back().height = (squares + steep_columns_ - 1) / steep_columns_ * kSteepSide;
  }

  int32_t Scaled(int32_t pixels) const { return (pixels + scale_ - 1) / scale_; }

  Point2 PixelsAt(int32_t vertex, int32_t raster) const {
    const RasterFrame& frame = rasters_[static_cast<size_t>(raster)].frame;
    return frame.PixelsOf(faces_.points[static_cast<size_t>(vertex)])
        .cwiseMax(Point2(0, 0))
        .cwiseMin(Point2(frame.width, frame.height));
  }

  uint8_t* PixelAt(int32_t x, int32_t y) {
    const auto row = static_cast<size_t>(atlas_.image.height - 1 - y);
    return &atlas_.image.pixels[3 * (row * static_cast<size_t>(atlas_.image.width) + static_cast<size_t>(x))];
  }

  // Viewers blend the pixels between the parts into them where they show the image much smaller than it is.
  void FillWithMean() {
    std::array<int64_t, 3> sum{};
    int64_t count = 0;
    const auto add = [&](Rgb c, int64_t pixels) {
      sum = {sum[0] + pixels * c.r, sum[1] + pixels * c.g, sum[2] + pixels * c.b};
      count += pixels;
    };
    for (size_t i = 0; i < rasters_.size(); ++i) {
      const RasterFrame& frame = rasters_[i].frame;
      const Part& part = parts_[i];
      const int32_t end_x = std::min(part.x + part.width * scale_, frame.width),
                    end_y = std::min(part.y + part.height * scale_, frame.height);
      for (int32_t y = part.y; y < end_y; ++y) {
        for (int32_t x = part.x; x < end_x; ++x) add(rasters_[i].colours[frame.At(x, y)], 1);
      }
    }
    for (const SquareColours& square : squares_) {
      for (const Rgb c : square) add(c, kSteepSide * kSteepSide / 3);
    }
    std::array<uint8_t, 3> mean{};
    for (size_t c = 0; c < 3; ++c) mean[c] = static_cast<uint8_t>((sum[c] + count / 2) / std::max<int64_t>(count, 1));
    const size_t pixels = static_cast<size_t>(atlas_.image.width) * static_cast<size_t>(atlas_.image.height);
    atlas_.image.pixels.reserve(3 * pixels);
    for (size_t i = 0; i < pixels; ++i) atlas_.image.pixels.insert(atlas_.image.pixels.end(), mean.begin(), mean.end());
  }

  // Means of scale x scale pixels.
  void CopyPart(const Part& part, const MadeRaster& raster) {
    for (int32_t y = 0; y < part.height; ++y) {
      for (int32_t x = 0; x < part.width; ++x) {
        std::array<int32_t, 3> sum{};
        int32_t count = 0;
        for (int32_t j = 0; j < scale_; ++j) {
          for (int32_t i = 0; i < scale_; ++i) {
            const int64_t px = part.x + x * scale_ + i, py = part.y + y * scale_ + j;
            if (!raster.frame.Has(px, py)) continue;
            const Rgb c = raster.colours[raster.frame.At(static_cast<int32_t>(px), static_cast<int32_t>(py))];
            sum[0] += c.r;
            sum[1] += c.g;
            sum[2] += c.b;
            ++count;
          }
        }
        uint8_t* const pixel = PixelAt(part.to_x + x, part.to_y + y);
        for (size_t c = 0; c < 3; ++c) pixel[c] = static_cast<uint8_t>((sum[c] + count / 2) / std::max(count, 1));
      }
    }
  }

  int32_t Add(double x, double y) {
    atlas_.coordinates.push_back(
        {static_cast<float>(x / atlas_.image.width), static_cast<float>(y / atlas_.image.height)});
    return static_cast<int32_t>(atlas_.coordinates.size()) - 1;
  }

  Triangle FlatCorners(size_t t) {
    const int32_t raster = faces_.rasters[t];
    const Part& part = parts_[static_cast<size_t>(raster)];
    Triangle corners;
    for (size_t k = 0; k < 3; ++k) {
      const int32_t vertex = faces_.triangles[t][k];
      const auto [it, fresh] = known_.try_emplace({raster, vertex}, 0);
      if (fresh) {
        const Point2 p = (PixelsAt(vertex, raster) - Point2(part.x, part.y)) / scale_;
        it->second = Add(part.to_x + std::clamp(p.x(), 0.5, part.width - 0.5),
                         part.to_y + std::clamp(p.y(), 0.5, part.height - 0.5));
      }
      corners[k] = it->second;
    }
    return corners;
  }

  // A square with the first corner's colour at its lower left, the second's at its right, the third's at its top.
  void DrawSquare(const SquareColours& c) {
    constexpr double kSpan = kSteepSide - 2 * kInset;
    const auto [x0, y0] = NextSquare();
    for (int32_t y = 0; y < kSteepSide; ++y) {
      for (int32_t x = 0; x < kSteepSide; ++x) {
        double b = std::clamp((x + 0.5 - kInset) / kSpan, 0.0, 1.0),
               d = std::clamp((y + 0.5 - kInset) / kSpan, 0.0, 1.0);
        if (b + d > 1) {  // beyond the third side: as on it
          const double sum = b + d;
          b /= sum;
          d /= sum;
        }
        const auto mix = [&](uint8_t first, uint8_t second, uint8_t third) {
          return static_cast<uint8_t>((1 - b - d) * first + b * second + d * third + 0.5);
        };
        uint8_t* const pixel = PixelAt(x0 + x, y0 + y);
        pixel[0] = mix(c[0].r, c[1].r, c[2].r);
        pixel[1] = mix(c[0].g, c[1].g, c[2].g);
        pixel[2] = mix(c[0].b, c[1].b, c[2].b);
      }
    }
    square_corners_.push_back(Add(x0 + kInset, y0 + kInset));
    Add(x0 + kInset + kSpan, y0 + kInset);
    Add(x0 + kInset, y0 + kInset + kSpan);
  }

  // The lower left corner of the square that is drawn next.
  std::pair<int32_t, int32_t> NextSquare() const {
    const Part& part = parts_.back();
    const auto drawn = static_cast<int32_t>(square_corners_.size());
    return {part.to_x + drawn % steep_columns_ * kSteepSide, part.to_y + drawn / steep_columns_ * kSteepSide};
  }

  Triangle SteepCorners(size_t t) const {
    const int32_t first = square_corners_[static_cast<size_t>(square_of_[t])];
    return {first, first + 1, first + 2};
  }

  static constexpr double kInset = 1.5;  // pixels of a square around its triangle

  const AtlasFaces& faces_;
  const std::span<const MadeRaster> rasters_;
  int32_t scale_ = 1;
  std::vector<Part> parts_;  // of each raster; the last is that of the steep triangles
  int32_t steep_columns_ = 1;
  std::vector<SquareColours> squares_;                    // of the steep triangles, each once
  std::vector<int32_t> square_of_;                        // of each triangle, into `squares_`; -1: none
  std::vector<int32_t> square_corners_;                   // of each square drawn: the first of its coordinates
  std::map<std::pair<int32_t, int32_t>, int32_t> known_;  // coordinates by raster and vertex
  Atlas atlas_;
};

}  // namespace

Atlas PackAtlas(const AtlasFaces& faces, std::span<const MadeRaster> rasters) {
  return AtlasPacker(faces, rasters).Pack();
}

}  // namespace tilemend
