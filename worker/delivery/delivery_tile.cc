#include "worker/delivery/delivery_tile.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/util/files.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "worker/materials/textured_surface.h"
#include "worker/materials/tile_look.h"

namespace tilemend {
namespace {

constexpr Rgb kPlain = {200, 200, 200};  // of surface without any look

// Collects surfaces of one image or colour, with the vertices that each one uses.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(DeliverySurface& surface) : surface_(surface) {}

  // A corner at a point with a place in the image; `key` is the same for corners that are one vertex.
  int32_t VertexOf(std::pair<int32_t, int32_t> key, const Point3& point, const std::array<float, 2>& uv) {
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<int32_t>(surface_.mesh.points.size()));
    if (is_new) {
      surface_.mesh.points.push_back(point);
      if (surface_.image >= 0) surface_.uv.push_back(uv);
    }
    return at->second;
  }

 private:
  DeliverySurface& surface_;
  std::map<std::pair<int32_t, int32_t>, int32_t> numbers_;
};

class TreeDelivery {
 public:
  TreeDelivery(const TileTree& tile, DeliveryLevels levels, std::span<const int32_t> new_geometries)
      : tile_(tile), levels_(levels), new_geometries_(new_geometries) {}

  DeliveryTile Make() {
    for (int32_t p = 0; p < std::ssize(tile_.pieces); ++p) {
      if (IsWanted(p)) AddOwnImages(tile_.pieces[static_cast<size_t>(p)], FirstNew(p));
    }
    result_.own_images = result_.images.size();
    for (int32_t p = 0; p < std::ssize(tile_.pieces); ++p) {
      numbers_.push_back(IsWanted(p) ? static_cast<int32_t>(result_.pieces.size()) : -1);
      if (IsWanted(p)) Add(tile_.pieces[static_cast<size_t>(p)], FirstNew(p));
    }
    return std::move(result_);
  }

 private:
  bool IsWanted(int32_t p) const {
    return levels_ == DeliveryLevels::kAll || tile_.pieces[static_cast<size_t>(p)].is_finest;
  }

  void AddOwnImages(const TreePiece& piece, int64_t first_new) {
    for (const TreeGeometry& geometry : tile_.files[static_cast<size_t>(piece.file)].geometries) {
      const bool is_own = geometry.part == piece.part && geometry.order < first_new;
      if (is_own && geometry.texture >= 0) ImageOf(piece.file, geometry.texture);
    }
  }

  // The lowest TreeGeometry::order of new geometry in a piece.
  int64_t FirstNew(int32_t p) const {
    constexpr int64_t kNone = std::numeric_limits<int64_t>::max();
    const size_t count = new_geometries_.empty() ? 0 : static_cast<size_t>(new_geometries_[static_cast<size_t>(p)]);
    if (count == 0) return kNone;
    const TreePiece& piece = tile_.pieces[static_cast<size_t>(p)];
    std::vector<int64_t> orders;
    for (const TreeGeometry& geometry : tile_.files[static_cast<size_t>(piece.file)].geometries) {
      if (geometry.part == piece.part) orders.push_back(geometry.order);
    }
    if (orders.size() < count) return kNone;
    std::ranges::sort(orders);
    return orders[orders.size() - count];
  }

  void Add(const TreePiece& piece, int64_t first_new) {
    DeliveryPiece made;
    if (levels_ == DeliveryLevels::kAll) {
      made.parent = piece.parent < 0 ? -1 : numbers_[static_cast<size_t>(piece.parent)];
      made.geometric_error = piece.geometric_error;
    }
    std::map<std::tuple<int32_t, uint32_t, bool>, size_t> surfaces;  // by image, colour, and whether it is new
    const TreeFile& file = tile_.files[static_cast<size_t>(piece.file)];
    for (const TreeGeometry& geometry : file.geometries) {
      if (geometry.part != piece.part || geometry.triangle_count == 0) continue;
      const int32_t image = geometry.texture < 0 ? -1 : ImageOf(piece.file, geometry.texture);
      const Rgb& c = geometry.colour;
      const uint32_t colour = image < 0 ? uint32_t{c.r} << 16 | uint32_t{c.g} << 8 | c.b : 0;
      const bool is_filled = geometry.order >= first_new;
      const auto [at, is_new] = surfaces.try_emplace({image, colour, is_filled}, made.surfaces.size());
      if (is_new) made.surfaces.push_back({{}, {}, image, c, {}, is_filled});
      Append(file, geometry, made.surfaces[at->second]);
    }
    result_.pieces.push_back(std::move(made));
  }

  static void Append(const TreeFile& file, const TreeGeometry& geometry, DeliverySurface& surface) {
    SurfaceBuilder builder(surface);
    for (int32_t t = geometry.first_triangle; t < geometry.first_triangle + geometry.triangle_count; ++t) {
      Triangle corners = file.triangles[static_cast<size_t>(t)];
      for (int32_t& corner : corners) {
        const auto v = static_cast<size_t>(corner);
        corner = builder.VertexOf({corner, 0}, file.points[v], file.uv[v]);
      }
      surface.mesh.triangles.push_back(corners);
    }
  }

  // The number of an image; -1 if its bytes are not there.
  int32_t ImageOf(int32_t f, int32_t index) {
    const auto [at, is_new] = images_.try_emplace({f, index}, -1);
    if (!is_new) return at->second;
    const PackedFile& packed = tile_.packed[static_cast<size_t>(f)];
    const TreeImage& image = tile_.files[static_cast<size_t>(f)].images[static_cast<size_t>(index)];
    const std::string_view bytes = packed.bytes.substr(image.offset, image.size);
    if (!image.is_encoded || ImageEnding(bytes).empty()) {
      result_.warnings.push_back(absl::StrCat(Printable(packed.name), ": image ", Printable(image.name),
                                              " is no image of a known format in this file; its faces are white"));
      return -1;
    }
    at->second = static_cast<int32_t>(result_.images.size());
    result_.images.emplace_back(bytes);
    return at->second;
  }

  const TileTree& tile_;
  const DeliveryLevels levels_;
  const std::span<const int32_t> new_geometries_;  // by piece; empty: there are none
  DeliveryTile result_;
  std::vector<int32_t> numbers_;  // of each piece in the result
  std::map<std::pair<int32_t, int32_t>, int32_t> images_;
};

// The name of the image of filled faces, whose bytes are in ObjBeside: no path in a scene is like it.
constexpr char kFilledImage[] = "/";

// The look of an OBJ tile with that of its filled faces, whose material file is not written yet.
absl::StatusOr<TileLook> LookWith(const ObjBeside& beside, const ObjTextures& textures) {
  TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadObjLook(beside.root, beside.path, textures));
  for (const FillMaterial& material : beside.filled) {
    look.materials[material.name] = {material.colour, material.image.empty() ? "" : kFilledImage};
  }
  return look;
}

// The bytes of an image; empty, with a warning, if it cannot be used.
absl::StatusOr<std::string> ReadImage(const ObjBeside& beside, const std::string& image,
                                      std::vector<std::string>& warnings) {
  if (image == kFilledImage) return std::string(beside.filled_image);
  auto bytes = ReadFile(absl::StrCat(beside.root, "/", image));
  if (IsStoreError(beside.root, bytes.status())) return bytes.status();
  if (!bytes.ok()) {
    warnings.emplace_back(bytes.status().message());
  } else if (ImageEnding(*bytes).empty()) {
    warnings.push_back(absl::StrCat(Printable(image), ": neither JPEG, PNG, WebP nor KTX2; its faces have one colour"));
  } else {
    return bytes;
  }
  return "";
}

// The images of the materials that the tile names, and last that of its filled faces.
std::vector<std::string> ImagesOf(const ObjTextures& textures, const TileLook& look) {
  std::set<std::string> own;
  bool has_filled = false;
  for (const std::string& name : textures.materials) {
    const auto material = look.materials.find(name);
    if (material == look.materials.end() || material->second.image.empty()) continue;
    has_filled = has_filled || material->second.image == kFilledImage;
    if (material->second.image != kFilledImage) own.insert(material->second.image);
  }
  std::vector<std::string> images(own.begin(), own.end());
  if (has_filled) images.emplace_back(kFilledImage);
  return images;
}

// Reads these images into the tile. The number of each that can be used, by its name.
absl::StatusOr<std::map<std::string, int32_t>> AddImages(const ObjBeside& beside,
                                                         const std::vector<std::string>& images, DeliveryTile& tile) {
  std::map<std::string, int32_t> numbers;
  for (const std::string& image : images) {
    TILEMEND_ASSIGN_OR_RETURN(std::string read, ReadImage(beside, image, tile.warnings));
    if (read.empty()) continue;
    numbers[image] = static_cast<int32_t>(tile.images.size());
    tile.images.push_back(std::move(read));
    if (image != kFilledImage) tile.own_images = tile.images.size();
  }
  return numbers;
}

// What an OBJ tile has beside its materials.
struct ObjMarks {
  std::vector<bool> is_filled;                // of each triangle
  std::vector<std::optional<Rgb>> of_vertex;  // colours; empty: there are none
};

ObjMarks MarksOf(const ObjFile& obj) {
  ObjMarks marks{std::vector<bool>(obj.file.mesh.triangles.size()), obj.textures.vertex_colours};
  const std::vector<ObjTextures::GroupRun>& groups = obj.textures.groups;
  for (size_t g = 0; g < groups.size(); ++g) {
    const size_t end = g + 1 < groups.size() ? static_cast<size_t>(groups[g + 1].first) : marks.is_filled.size();
    for (auto t = static_cast<size_t>(groups[g].first); t < end; ++t) marks.is_filled[t] = groups[g].is_filled;
  }
  return marks;
}

Rgb MeanOf(const std::vector<Rgb>& colours) {
  std::array<size_t, 3> sum{};
  for (const Rgb& c : colours) sum = {sum[0] + c.r, sum[1] + c.g, sum[2] + c.b};
  const auto mean = [&](size_t k) { return static_cast<uint8_t>((sum[k] + colours.size() / 2) / colours.size()); };
  return {mean(0), mean(1), mean(2)};
}

// The triangles of the group that are filled, or the others.
DeliverySurface SurfaceOf(const TexturedSurface& all, const TexturedSurface::Group& group, int32_t image,
                          const ObjMarks& marks, bool is_filled) {
  DeliverySurface surface{{}, {}, image, group.colour.value_or(kPlain), {}, is_filled};
  const bool has_own = image < 0 && !group.colour && group.image.empty() && !marks.of_vertex.empty();
  SurfaceBuilder builder(surface);
  for (const int32_t t : group.triangles) {
    if (marks.is_filled[static_cast<size_t>(t)] != is_filled) continue;
    Triangle corners = all.mesh.triangles[static_cast<size_t>(t)];
    for (size_t k = 0; k < 3; ++k) {
      const int32_t place = image < 0 ? -1 : all.corners[static_cast<size_t>(t)][k];
      const std::array<float, 2> uv = image < 0 ? std::array<float, 2>{} : all.coordinates[static_cast<size_t>(place)];
      const auto v = static_cast<size_t>(corners[k]);
      corners[k] = builder.VertexOf({corners[k], place}, all.mesh.points[v], uv);
      const bool is_new = has_own && surface.colours.size() < surface.mesh.points.size();
      if (is_new) surface.colours.push_back(marks.of_vertex[v].value_or(kPlain));
    }
    surface.mesh.triangles.push_back(corners);
  }
  if (!surface.colours.empty()) surface.colour = MeanOf(surface.colours);
  return surface;
}

bool IsUnderMaterial(const DeliverySurface& surface) { return !surface.is_filled && surface.colours.empty(); }

}  // namespace

std::string_view ImageEnding(std::string_view image) {
  if (image.starts_with("\xff\xd8\xff")) return "jpg";
  if (image.starts_with("\x89PNG")) return "png";
  if (image.starts_with("RIFF") && image.substr(0, 12).ends_with("WEBP")) return "webp";
  if (image.starts_with("\xabKTX 20\xbb")) return "ktx2";
  return "";
}

DeliveryTile DeliveryOfTree(const TileTree& tile, DeliveryLevels levels, std::span<const int32_t> new_geometries) {
  return TreeDelivery(tile, levels, new_geometries).Make();
}

absl::StatusOr<DeliveryTile> DeliveryOfObj(std::string_view bytes, const ObjBeside& beside) {
  TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, beside.path, NoFaces::kAccept, FlatFaces::kKeep));
  const int64_t short_faces = obj.textures.short_faces, lines_and_points = obj.textures.lines_and_points;
  TILEMEND_ASSIGN_OR_RETURN(const TileLook look, LookWith(beside, obj.textures));
  const ObjMarks marks = MarksOf(obj);
  const std::vector<std::string> images = ImagesOf(obj.textures, look);
  const TexturedSurface surface = TexturedSurfaceOf(std::move(obj), look);
  DeliveryTile tile;
  const auto warn_of = [&](const char* what, int64_t count) {
    if (count == 0) return;
    tile.warnings.push_back(
        absl::StrCat(Printable(beside.path), ": ", what, " are not written in another format: ", count));
  };
  warn_of("faces with fewer than three corners", short_faces);
  warn_of("lines and points", lines_and_points);
  DeliveryPiece piece;
  TILEMEND_ASSIGN_OR_RETURN(const auto numbers, AddImages(beside, images, tile));
  for (const TexturedSurface::Group& group : surface.groups) {
    const auto number = numbers.find(group.image);
    const int32_t image = number == numbers.end() ? -1 : number->second;
    for (const bool is_filled : {false, true}) {
      DeliverySurface made = SurfaceOf(surface, group, image, marks, is_filled);
      if (!made.mesh.triangles.empty()) piece.surfaces.push_back(std::move(made));
    }
  }
  if (!marks.of_vertex.empty() && std::ranges::any_of(piece.surfaces, IsUnderMaterial)) {
    tile.warnings.emplace_back("colours of vertices are not written where faces have a material");
  }
  tile.pieces.push_back(std::move(piece));
  return tile;
}

void KeepJpegAndPng(DeliveryTile& tile) {
  std::set<std::string_view> left_out;
  for (DeliveryPiece& piece : tile.pieces) {
    for (DeliverySurface& surface : piece.surfaces) {
      if (surface.image < 0) continue;
      const std::string_view ending = ImageEnding(tile.images[static_cast<size_t>(surface.image)]);
      if (ending == "jpg" || ending == "png") continue;
      left_out.insert(ending);
      surface.image = -1;
      surface.uv.clear();
    }
  }
  for (const std::string_view ending : left_out) {
    tile.warnings.push_back(absl::StrCat("images of the format ", std::string(ending),
                                         " are not written in this format; their faces have one colour"));
  }
}

void DropVertexColours(DeliveryTile& tile) {
  bool any = false;
  for (DeliveryPiece& piece : tile.pieces) {
    for (DeliverySurface& surface : piece.surfaces) {
      any = any || !surface.colours.empty();
      surface.colours.clear();
    }
  }
  if (any) {
    tile.warnings.emplace_back("colours of vertices are not written in this format; their faces have one colour");
  }
}

DeliveryTile DeliveryOfColours(const TriMesh& mesh, std::span<const ColourRun> runs) {
  DeliveryTile tile;
  DeliveryPiece& piece = tile.pieces.emplace_back();
  for (size_t r = 0; r < runs.size(); ++r) {
    DeliverySurface surface{{}, {}, -1, runs[r].colour, {}, true};
    SurfaceBuilder builder(surface);
    const size_t end = r + 1 < runs.size() ? static_cast<size_t>(runs[r + 1].first) : mesh.triangles.size();
    for (auto t = static_cast<size_t>(runs[r].first); t < end; ++t) {
      Triangle corners = mesh.triangles[t];
      for (int32_t& corner : corners) {
        corner = builder.VertexOf({corner, 0}, mesh.points[static_cast<size_t>(corner)], {});
      }
      surface.mesh.triangles.push_back(corners);
    }
    piece.surfaces.push_back(std::move(surface));
  }
  return tile;
}

}  // namespace tilemend
