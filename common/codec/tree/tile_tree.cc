#include "common/codec/tree/tile_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/match.h"
#include "common/codec/osgb/osgb_tile.h"
#include "common/codec/tiles3d/tileset_tree.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr Rgb kNoColour = {255, 255, 255};  // as viewers draw what has no material

// Of linear colours.
Rgb SrgbOf(const std::array<double, 4>& linear) {
  const auto channel = [](double value) {
    value = std::clamp(value, 0.0, 1.0);
    value = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    return static_cast<uint8_t>(std::lround(255 * value));
  };
  return {channel(linear[0]), channel(linear[1]), channel(linear[2])};
}

bool IsTilesetPack(const std::vector<PackedFile>& packed) {
  return !packed.empty() && absl::EndsWithIgnoreCase(packed[0].name, ".json");
}

TreeFile FromOsgb(OsgbFile file) {
  TreeFile result{std::move(file.points), std::move(file.uv), std::move(file.triangles), {}, {}};
  for (const OsgbGeometry& g : file.geometries) {
    result.geometries.push_back({g.first_vertex, g.vertex_count, g.first_triangle, g.triangle_count, g.texture,
                                 g.colour.value_or(kNoColour), g.geode, g.colour.has_value(),
                                 std::ssize(result.geometries)});
  }
  for (OsgbImage& image : file.images) {
    const bool is_encoded = image.storage == OsgbImage::Storage::kEncoded;
    result.images.push_back({std::move(image.name), image.offset, image.size, is_encoded});
  }
  return result;
}

absl::StatusOr<TileTree> ReadOsgbTree(std::string_view pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(OsgbTile tile, ReadOsgbTile(pack, name));
  TileTree tree;
  tree.packed = std::move(tile.packed);
  for (OsgbFile& file : tile.files) tree.files.push_back(FromOsgb(std::move(file)));
  for (const OsgbPiece& p : tile.pieces)
    tree.pieces.push_back({p.file, p.geode, p.level, p.is_finest, p.parent, p.geometric_error});
  tree.levels = tile.levels;
  tree.missing = std::move(tile.missing);
  return tree;
}

// All of a model is one part: a viewer replaces the file.
TreeFile FromGltf(GltfFile file) {
  TreeFile result{std::move(file.points), std::move(file.uv), std::move(file.triangles), {}, {}};
  for (const GltfPrimitive& p : file.primitives) {
    result.geometries.push_back({p.first_vertex, p.vertex_count, p.first_triangle, p.triangle_count, p.texture,
                                 SrgbOf(p.base_colour), 0, p.has_base_colour,
                                 file.nodes[static_cast<size_t>(p.node)].number});
  }
  for (GltfImage& image : file.images) {
    result.images.push_back({std::move(image.name), image.offset, image.size, image.size > 0});
  }
  return result;
}

absl::StatusOr<TileTree> ReadModelTree(std::string_view pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(TilesetTree tile, ReadTilesetTree(pack, name));
  TileTree tree;
  tree.files.resize(tile.packed.size());
  for (TilesetModel& model : tile.models) {
    tree.pieces.push_back({model.file, 0, model.level, model.is_finest, model.parent, model.geometric_error});
    tree.files[static_cast<size_t>(model.file)] = FromGltf(std::move(model.gltf));
  }
  tree.packed = std::move(tile.packed);
  tree.levels = tile.levels;
  tree.missing = std::move(tile.missing);
  return tree;
}

void AddPart(const TileTree& tile, int32_t piece, TreeLevel& level) {
  const TreeFile& file = tile.files[tile.pieces[piece].file];
  TreeLevel::Part part{
      piece, {}, static_cast<int32_t>(level.mesh.points.size()), static_cast<int32_t>(level.mesh.triangles.size())};
  for (int32_t g = 0; g < std::ssize(file.geometries); ++g) {
    const TreeGeometry& geometry = file.geometries[g];
    if (geometry.part != tile.pieces[piece].part) continue;
    part.geometries.push_back(g);
    const int32_t shift = static_cast<int32_t>(level.mesh.points.size()) - geometry.first_vertex;
    const auto points = file.points.begin() + geometry.first_vertex;
    level.mesh.points.insert(level.mesh.points.end(), points, points + geometry.vertex_count);
    for (int32_t t = 0; t < geometry.triangle_count; ++t) {
      const Triangle& of_file = file.triangles[geometry.first_triangle + t];
      level.mesh.triangles.push_back({of_file[0] + shift, of_file[1] + shift, of_file[2] + shift});
    }
  }
  if (!part.geometries.empty()) level.parts.push_back(std::move(part));
}

}  // namespace

absl::StatusOr<TileTree> ReadTileTree(std::string_view pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<PackedFile> packed, UnpackFiles(pack, name));
  return IsTilesetPack(packed) ? ReadModelTree(pack, name) : ReadOsgbTree(pack, name);
}

TreeLevel LevelOf(const TileTree& tile, int32_t level) {
  TreeLevel result;
  for (int32_t p = 0; p < std::ssize(tile.pieces); ++p) {
    const TreePiece& piece = tile.pieces[p];
    if (piece.level == level || (piece.level < level && piece.is_finest)) AddPart(tile, p, result);
  }
  return result;
}

absl::StatusOr<std::string> ChangeTileTree(const TileTree& tile, const std::vector<TreeEdit>& edits,
                                           const std::string& name) {
  if (IsTilesetPack(tile.packed)) {
    std::vector<TilesetEdit> changes;
    for (const TreeEdit& edit : edits) {
      TilesetEdit& change = changes.emplace_back(TilesetEdit{edit.drop, {}});
      for (const TreePatch& p : edit.patches)
        change.patches.push_back({p.points, p.uv, p.triangles, p.image, p.image_name, p.colour});
    }
    return ChangeTilesetTree(tile.packed, changes, name);
  }
  std::vector<OsgbEdit> changes;
  for (const TreeEdit& edit : edits) {
    OsgbEdit& change = changes.emplace_back(OsgbEdit{edit.drop, {}});
    for (const TreePatch& p : edit.patches) {
      change.patches.push_back({p.points, p.uv, p.triangles, p.image, p.image_name, p.colour, p.part});
    }
  }
  return ChangeOsgbTile(tile.packed, changes, name);
}

std::string_view TreeImageIn(std::string_view bytes, int32_t image, const std::string& file_name) {
  TreeFile file;
  if (absl::EndsWithIgnoreCase(file_name, ".osgb")) {
    if (auto osgb = ReadOsgb(bytes, file_name); osgb.ok()) file = FromOsgb(*std::move(osgb));
  } else if (auto gltf = ReadGltf(bytes, GltfUpAxis::kY, file_name); gltf.ok()) {
    file = FromGltf(*std::move(gltf));
  }
  if (image < 0 || image >= std::ssize(file.images)) return {};
  const TreeImage& found = file.images[static_cast<size_t>(image)];
  return found.is_encoded ? bytes.substr(found.offset, found.size) : std::string_view();
}

}  // namespace tilemend
