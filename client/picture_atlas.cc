#include "client/picture_atlas.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr int32_t kWhiteRows = 16;  // below the parts: a block of the JPEG and its neighbour
constexpr int kQuality = 78;

// Pixels [x0, x1) x [y0, y1) of an image.
struct PixelBox {
  int32_t x0, y0, x1, y1;
};

PixelBox PixelsOf(const ImagePart& part, const Image& image) {
  const auto at = [](double share, int32_t side) {
    return std::clamp(static_cast<int32_t>(std::floor(share * side)), 0, side - 1);
  };
  return {at(part.lo[0], image.width), at(1.0 - part.hi[1], image.height), at(part.hi[0], image.width) + 1,
          at(1.0 - part.lo[1], image.height) + 1};
}

// Draws the box of `from` scaled into the square: each pixel is the mean of what it covers.
void DrawScaled(const Image& from, const PixelBox& box, int32_t left, int32_t top, int32_t width, int32_t height,
                Image& to) {
  for (int32_t y = 0; y < height; ++y) {
    const int32_t y0 = box.y0 + static_cast<int32_t>(int64_t{y} * (box.y1 - box.y0) / height);
    const int32_t y1 = std::max(y0 + 1, box.y0 + static_cast<int32_t>(int64_t{y + 1} * (box.y1 - box.y0) / height));
    for (int32_t x = 0; x < width; ++x) {
      const int32_t x0 = box.x0 + static_cast<int32_t>(int64_t{x} * (box.x1 - box.x0) / width);
      const int32_t x1 = std::max(x0 + 1, box.x0 + static_cast<int32_t>(int64_t{x + 1} * (box.x1 - box.x0) / width));
      std::array<int64_t, 3> sum{};
      for (int32_t v = y0; v < y1; ++v) {
        for (int32_t u = x0; u < x1; ++u) {
          const size_t at = (static_cast<size_t>(v) * static_cast<size_t>(from.width) + static_cast<size_t>(u)) *
                            static_cast<size_t>(from.channels);
          for (size_t c = 0; c < 3; ++c) sum[c] += from.pixels[at + (from.channels >= 3 ? c : 0)];
        }
      }
      const int64_t count = int64_t{y1 - y0} * (x1 - x0);
      const size_t at =
          3 * (static_cast<size_t>(top + y) * static_cast<size_t>(to.width) + static_cast<size_t>(left + x));
      for (size_t c = 0; c < 3; ++c) to.pixels[at + c] = static_cast<uint8_t>(sum[c] / count);
    }
  }
}

}  // namespace

std::array<double, 2> PictureAtlas::PlaceOf(const ImagePart& part, size_t number, std::array<float, 2> uv) const {
  const Square& square = squares[number];
  std::array<double, 2> share;
  for (size_t k = 0; k < 2; ++k) {
    const double length = std::max(1e-9, static_cast<double>(part.hi[k]) - static_cast<double>(part.lo[k]));
    share[k] = std::clamp((static_cast<double>(uv[k]) - static_cast<double>(part.lo[k])) / length, 0.0, 1.0);
  }
  return {square.u + share[0] * square.width, square.v + (1 - share[1]) * square.height};
}

namespace {

// The bytes of an image in those of its file; empty if the file has none there.
std::string_view ImageIn(std::string_view bytes, const ImagePart& part) {
  return part.number < 0 ? bytes : TreeImageIn(bytes, part.number, part.path);
}

}  // namespace

PictureAtlas MakePictureAtlas(const std::string& root, const std::vector<ImagePart>& parts) {
  PictureAtlas atlas;
  atlas.squares.resize(parts.size());
  if (parts.empty()) return atlas;
  const auto columns = static_cast<int32_t>(std::ceil(std::sqrt(static_cast<double>(parts.size()))));
  const int32_t side = std::max(1, kAtlasSide / columns), full = side * columns;
  Image image{
      full, full + kWhiteRows, 3,
      std::vector<uint8_t>(size_t{3} * static_cast<size_t>(full) * static_cast<size_t>(full + kWhiteRows), 255)};
  bool any = false;
  for (size_t i = 0; i < parts.size(); ++i) {
    const auto bytes = ReadFile(absl::StrCat(root, "/", parts[i].path));
    if (!bytes.ok()) continue;
    const auto decoded = DecodeImage(ImageIn(*bytes, parts[i]), parts[i].path);
    if (!decoded.ok() || decoded->width < 1 || decoded->height < 1) continue;
    const PixelBox box = PixelsOf(parts[i], *decoded);
    const int32_t width = std::min(side, box.x1 - box.x0), height = std::min(side, box.y1 - box.y0);
    const int32_t left = static_cast<int32_t>(i) % columns * side, top = static_cast<int32_t>(i) / columns * side;
    DrawScaled(*decoded, box, left, top, width, height, image);
    atlas.squares[i] = {static_cast<double>(left) / image.width, static_cast<double>(top) / image.height,
                        static_cast<double>(width) / image.width, static_cast<double>(height) / image.height};
    any = true;
  }
  atlas.white = {0.5, (full + 0.75 * kWhiteRows) / image.height};
  if (!any) return atlas;
  auto jpeg = EncodeJpeg(image, kQuality);
  if (jpeg.ok()) atlas.jpeg = *std::move(jpeg);
  return atlas;
}

}  // namespace tilemend
