#include "worker/delivery/ply_delivery.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/ply_header.h"
#include "common/image/image.h"
#include "common/util/status_macros.h"

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

namespace tilemend {
namespace {

uint32_t NumberOf(const Rgb& colour) { return uint32_t{colour.r} << 16 | uint32_t{colour.g} << 8 | uint32_t{colour.b}; }

// Of one block, at a quality that changes a colour by a step or two at most.
absl::StatusOr<std::string> PlainJpeg(const Rgb& colour) {
  constexpr int kSide = 8, kQuality = 100;
  Image image;
  image.width = image.height = kSide;
  for (int i = 0; i < kSide * kSide; ++i) image.pixels.insert(image.pixels.end(), {colour.r, colour.g, colour.b});
  return EncodeJpeg(image, kQuality);
}

bool IsAnyFilled(const DeliveryTile& tile) {
  return std::ranges::any_of(tile.pieces, [](const DeliveryPiece& piece) {
    return std::ranges::any_of(piece.surfaces, &DeliverySurface::is_filled);
  });
}

using Position = std::array<uint64_t, 3>;  // its bits

Position PositionOf(const Point3& point) {
  Position bits;
  for (size_t axis = 0; axis < 3; ++axis) bits[axis] = std::bit_cast<uint64_t>(point[static_cast<int>(axis)]);
  return bits;
}

// The positions on the rim of a piece: an edge there is not in as many triangles one way as the other.
std::set<Position> RimOf(const DeliveryPiece& piece) {
  std::map<Position, int32_t> number;
  std::vector<std::pair<std::pair<int32_t, int32_t>, int32_t>> edges;  // from lower to higher, and 1, or back and -1
  for (const DeliverySurface& surface : piece.surfaces) {
    for (const Triangle& triangle : surface.mesh.triangles) {
      std::array<int32_t, 3> at{};
      for (size_t k = 0; k < 3; ++k) {
        const Position position = PositionOf(surface.mesh.points[static_cast<size_t>(triangle[k])]);
        at[k] = number.try_emplace(position, static_cast<int32_t>(number.size())).first->second;
      }
      for (size_t k = 0; k < 3; ++k) {
        const int32_t from = at[k], to = at[(k + 1) % 3];
        if (from != to) edges.emplace_back(std::minmax(from, to), from < to ? 1 : -1);
      }
    }
  }
  std::ranges::sort(edges);
  std::vector<bool> is_rim(number.size(), false);
  for (size_t i = 0, j = 0; i < edges.size(); i = j) {
    int32_t more = 0;
    for (; j < edges.size() && edges[j].first == edges[i].first; ++j) more += edges[j].second;
    if (more != 0) is_rim[edges[i].first.first] = is_rim[edges[i].first.second] = true;
  }
  std::set<Position> rim;
  for (const auto& [position, at] : number) {
    if (is_rim[at]) rim.insert(position);
  }
  return rim;
}

class PlyMaker {
 public:
  PlyMaker(const DeliveryTile& tile, const std::string& stem, const PlyColumns& columns)
      : tile_(tile),
        stem_(stem),
        has_images_(HasImages(tile, columns)),
        has_marks_(IsAnyFilled(tile)),
        is_narrow_(!columns.float64) {}

  absl::StatusOr<std::vector<DeliveryFile>> Make() {
    files_.push_back({stem_ + ".ply", ""});
    for (size_t i = 0; i < tile_.own_images; ++i) images_[{static_cast<int32_t>(i), 0}] = AddImage(tile_.images[i]);
    for (const bool is_filled : {false, true}) TILEMEND_RETURN_IF_ERROR(AddImagesOf(is_filled));
    for (const DeliveryPiece& piece : tile_.pieces) {
      ++piece_;
      if (tile_.pieces.size() > 1) rim_ = RimOf(piece);
      for (const DeliverySurface& surface : piece.surfaces) {
        const int32_t image = has_images_ ? images_.at(ImageOf(surface)) : -1;
        for (const Triangle& triangle : surface.mesh.triangles) AddFace(surface, triangle, image);
      }
    }
    files_[0].bytes = absl::StrCat(Header(), Vertices(), faces_);
    return std::move(files_);
  }

 private:
  using VertexKey = std::tuple<Position, uint32_t, int32_t>;  // with the colour and the piece

  int32_t AddImage(std::string bytes) {
    const auto number = static_cast<int32_t>(files_.size()) - 1;
    std::string name = absl::StrCat(stem_, "_", number, ".", std::string(ImageEnding(bytes)));
    files_.push_back({std::move(name), std::move(bytes)});
    return number;
  }

  using ImageKey = std::pair<int32_t, uint32_t>;  // into DeliveryTile::images, or -1 and a colour

  static ImageKey ImageOf(const DeliverySurface& surface) {
    return {surface.image, surface.image < 0 ? NumberOf(surface.colour) : 0};
  }

  // Of filled surface, or the other.
  absl::Status AddImagesOf(bool is_filled) {
    if (!has_images_) return absl::OkStatus();
    for (const DeliveryPiece& piece : tile_.pieces) {
      for (const DeliverySurface& surface : piece.surfaces) {
        if (surface.is_filled != is_filled) continue;
        const auto [at, is_new] = images_.try_emplace(ImageOf(surface), 0);
        if (!is_new) continue;
        std::string bytes;
        if (surface.image >= 0) {
          bytes = tile_.images[static_cast<size_t>(surface.image)];
        } else {
          TILEMEND_ASSIGN_OR_RETURN(bytes, PlainJpeg(surface.colour));
        }
        at->second = AddImage(std::move(bytes));
      }
    }
    return absl::OkStatus();
  }

  void AddFace(const DeliverySurface& surface, const Triangle& triangle, int32_t image) {
    faces_ += '\3';
    std::array<int32_t, 3> numbers{};
    for (size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<size_t>(triangle[k]);
      const Rgb& colour = surface.colours.empty() ? surface.colour : surface.colours[v];
      const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(k);
      numbers[k] = VertexOf(surface.mesh.points[v], colour);
      // Readers leave out a face that names one vertex twice.
      if (std::find(numbers.begin(), end, numbers[k]) != end) numbers[k] = NewVertex(surface.mesh.points[v], colour);
      AppendNumber(numbers[k], faces_);
    }
    if (image >= 0) AddPlaces(surface, triangle, image);
    if (has_marks_) faces_ += surface.is_filled ? '\1' : '\0';
    ++face_count_;
  }

  void AddPlaces(const DeliverySurface& surface, const Triangle& triangle, int32_t image) {
    constexpr std::array<float, 2> kMiddle = {0.5F, 0.5F};
    faces_ += '\6';
    for (const int32_t corner : triangle) {
      for (const float place : surface.uv.empty() ? kMiddle : surface.uv[static_cast<size_t>(corner)]) {
        AppendNumber(place, faces_);
      }
    }
    AppendNumber(image, faces_);
  }

  int32_t VertexOf(const Point3& point, const Rgb& colour) {
    const Position position = PositionOf(point);
    const bool is_shared = tile_.pieces.size() == 1 || rim_.contains(position);
    const VertexKey key = {position, has_images_ ? 0 : NumberOf(colour), is_shared ? -1 : piece_};
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<int32_t>(points_.size()));
    return is_new ? NewVertex(point, colour) : at->second;
  }

  int32_t NewVertex(const Point3& point, const Rgb& colour) {
    points_.push_back(point);
    if (!has_images_) colours_.push_back(colour);
    is_narrow_ = is_narrow_ && point == point.cast<float>().cast<double>();
    return static_cast<int32_t>(points_.size()) - 1;
  }

  std::string Header() const {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (size_t f = 1; f < files_.size(); ++f) absl::StrAppend(&text, "comment TextureFile ", files_[f].name, "\n");
    absl::StrAppend(&text, "element vertex ", points_.size(), "\n");
    for (const char* axis : {"x", "y", "z"}) {
      absl::StrAppend(&text, "property ", is_narrow_ ? "float " : "double ", axis, "\n");
    }
    if (!has_images_) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    absl::StrAppend(&text, "element face ", face_count_, "\nproperty list uchar int vertex_indices\n");
    if (has_images_) text += "property list uchar float texcoord\nproperty int texnumber\n";
    if (has_marks_) absl::StrAppend(&text, "property uchar ", std::string(kFilledProperty), "\n");
    return text + "end_header\n";
  }

  std::string Vertices() const {
    std::string bytes;
    for (size_t v = 0; v < points_.size(); ++v) {
      for (const double value : points_[v]) {
        is_narrow_ ? AppendNumber(static_cast<float>(value), bytes) : AppendNumber(value, bytes);
      }
      if (has_images_) continue;
      for (const uint8_t channel : {colours_[v].r, colours_[v].g, colours_[v].b}) bytes += static_cast<char>(channel);
    }
    return bytes;
  }

  // Little-endian.
  template <typename Number>
  static void AppendNumber(Number value, std::string& bytes) {
    std::array<char, sizeof(Number)> own = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    bytes.append(own.data(), own.size());
  }

  const DeliveryTile& tile_;
  const std::string& stem_;
  const bool has_images_, has_marks_;
  std::vector<DeliveryFile> files_;
  std::map<ImageKey, int32_t> images_;  // their numbers
  int32_t piece_ = -1;                  // that is written
  std::set<Position> rim_;              // of it, where there are several
  std::map<VertexKey, int32_t> numbers_;
  std::vector<Point3> points_;
  std::vector<Rgb> colours_;
  bool is_narrow_;  // float32 is enough
  std::string faces_;
  int64_t face_count_ = 0;
};

}  // namespace

bool HasImages(const DeliveryTile& tile, const PlyColumns& columns) { return columns.images || !tile.images.empty(); }

absl::StatusOr<std::vector<DeliveryFile>> PlyFilesOf(const DeliveryTile& tile, const std::string& stem,
                                                     const PlyColumns& columns) {
  return PlyMaker(tile, stem, columns).Make();
}

}  // namespace tilemend
