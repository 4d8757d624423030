#include "client/crop_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include "client/picture_atlas.h"
#include "common/util/colour.h"

namespace tilemend {
namespace {

constexpr Rgb kBare = {190, 188, 182};  // surface of which no colour is known

template <typename Value>
void Append(Value value, std::string& out) {  // the targets are little-endian (cmake checks the byte order of records)
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(Value));
  out.append(bytes.data(), bytes.size());
}

uint16_t Quantized(double share) { return static_cast<uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535)); }

class CropWriter {
 public:
  CropWriter(const HoleCrop& crop, const TilePair& tile) : crop_(crop), tile_(tile) {
    for (const HoleCrop::Face& face : crop.faces) {
      for (const Point3& p : face.corners) box_.extend(p);
      AddToPart(face);
    }
  }

  std::string Write(const std::string& before, const std::string& after) {
    MakeAtlases(before, after);
    for (const HoleCrop::Face& face : crop_.faces) AddFace(face);
    std::string out = "TMC1";
    Append(static_cast<uint32_t>(vertices_.size()), out);
    Append(static_cast<uint32_t>(crop_.faces.size()), out);
    Append(static_cast<uint32_t>(atlas_.jpeg.size()), out);
    for (const Point3& p : {Point3(box_.min()), Point3(box_.max())}) {
      for (int k = 0; k < 3; ++k) Append(p[k], out);
    }
    for (const Vertex& v : order_)
      for (const uint16_t x : v.position) Append(x, out);
    for (const Vertex& v : order_)
      for (const uint16_t x : v.place) Append(x, out);
    for (const Vertex& v : order_)
      for (const uint8_t x : v.colour) Append(x, out);
    for (const HoleCrop::Face& face : crop_.faces) Append(static_cast<uint8_t>(face.state), out);
    out.resize((out.size() + 3) / 4 * 4, '\0');
    for (const uint32_t corner : corners_) Append(corner, out);
    return out + atlas_.jpeg;
  }

 private:
  struct Vertex {
    std::array<uint16_t, 3> position;
    std::array<uint16_t, 2> place;
    std::array<uint8_t, 4> colour;
    auto operator<=>(const Vertex&) const = default;
  };

  const PictureTile& TileOf(const HoleCrop::Face& face) const {
    return face.state == FaceState::kCleared ? tile_.before : tile_.after;
  }

  // The material of a face with an image and texture coordinates, or null.
  const PictureTile::Material* ImageOf(const HoleCrop::Face& face) const {
    const PictureTile& tile = TileOf(face);
    const int32_t m = tile.material_of[static_cast<size_t>(face.triangle)];
    if (m < 0 || tile.coordinates.empty() || tile.materials[static_cast<size_t>(m)].image.empty()) return nullptr;
    for (const auto& uv : tile.coordinates[static_cast<size_t>(face.triangle)]) {
      if (!std::isfinite(uv[0]) || !std::isfinite(uv[1])) return nullptr;
    }
    return &tile.materials[static_cast<size_t>(m)];
  }

  void AddToPart(const HoleCrop::Face& face) {
    const PictureTile::Material* material = ImageOf(face);
    if (material == nullptr) return;
    const auto [it, fresh] = number_.try_emplace(std::pair(material->image, material->number), parts_.size());
    if (fresh) parts_.push_back({.path = material->image, .number = material->number});
    ImagePart& part = parts_[it->second];
    for (const auto& uv : TileOf(face).coordinates[static_cast<size_t>(face.triangle)]) {
      for (size_t k = 0; k < 2; ++k) {
        part.lo[k] = std::min(part.lo[k], std::clamp(uv[k], 0.0F, 1.0F));
        part.hi[k] = std::max(part.hi[k], std::clamp(uv[k], 0.0F, 1.0F));
      }
    }
  }

  // Images of the output are those of the input and more. Without textures in the output the input has them.
  void MakeAtlases(const std::string& before, const std::string& after) {
    atlas_ = MakePictureAtlas(after, parts_);
    if (atlas_.jpeg.empty()) atlas_ = MakePictureAtlas(before, parts_);
  }

  std::array<uint8_t, 4> ColourOf(const HoleCrop::Face& face, size_t corner) const {
    const PictureTile& tile = TileOf(face);
    const auto t = static_cast<size_t>(face.triangle);
    Rgb colour = kBare;
    if (!tile.vertex_colours.empty()) {
      colour = tile.vertex_colours[static_cast<size_t>(tile.faces.mesh.triangles[t][corner])];
    } else if (const int32_t m = tile.material_of[t]; m >= 0 && tile.materials[static_cast<size_t>(m)].image.empty()) {
      colour = tile.materials[static_cast<size_t>(m)].colour;
    }
    return {colour.r, colour.g, colour.b, 255};
  }

  void AddFace(const HoleCrop::Face& face) {
    const PictureTile::Material* image = ImageOf(face);
    const size_t part = image == nullptr ? 0 : number_.at({image->image, image->number});
    const bool textured = image != nullptr && !atlas_.jpeg.empty() && atlas_.squares[part].width > 0;
    for (size_t k = 0; k < 3; ++k) {
      Vertex v{};
      const Eigen::Vector3d size = box_.sizes().cwiseMax(1e-9);
      for (int a = 0; a < 3; ++a)
        v.position[static_cast<size_t>(a)] = Quantized((face.corners[k][a] - box_.min()[a]) / size[a]);
      const std::array<double, 2> place =
          textured ? atlas_.PlaceOf(parts_[part], part, TileOf(face).coordinates[static_cast<size_t>(face.triangle)][k])
                   : atlas_.white;
      v.place = {Quantized(place[0]), Quantized(place[1])};
      v.colour = textured ? std::array<uint8_t, 4>{255, 255, 255, 255} : ColourOf(face, k);
      const auto [it, fresh] = vertices_.try_emplace(v, static_cast<uint32_t>(order_.size()));
      if (fresh) order_.push_back(v);
      corners_.push_back(it->second);
    }
  }

  const HoleCrop& crop_;
  const TilePair& tile_;
  Eigen::AlignedBox3d box_;
  std::map<std::pair<std::string, int32_t>, size_t> number_;  // of an image in parts_
  std::vector<ImagePart> parts_;
  PictureAtlas atlas_;
  std::map<Vertex, uint32_t> vertices_;
  std::vector<Vertex> order_;
  std::vector<uint32_t> corners_;
};

}  // namespace

std::string CropBytes(const HoleCrop& crop, const TilePair& tile, const std::string& before, const std::string& after) {
  return CropWriter(crop, tile).Write(before, after);
}

}  // namespace tilemend
