#include "client/picture_tile.h"

#include <numeric>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/obj.h"
#include "common/codec/ply_colours.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"
#include "worker/materials/tile_look.h"

namespace tilemend {
namespace {

absl::Status AddObjLook(const std::string& root, const std::string& path, const ObjTextures& textures,
                        PictureTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(const TileLook look, ReadObjLook(root, path, textures));
  for (const std::string& name : textures.materials) {
    PictureTile::Material& material = tile.materials.emplace_back();
    const auto found = look.materials.find(name);
    if (found == look.materials.end()) continue;
    material.image = found->second.image;
    if (found->second.diffuse) material.colour = *found->second.diffuse;
  }
  const size_t count = tile.faces.mesh.triangles.size();
  tile.material_of.assign(count, -1);
  for (size_t r = 0; r < textures.runs.size(); ++r) {
    const auto first = static_cast<size_t>(textures.runs[r].first);
    const size_t last = r + 1 < textures.runs.size() ? static_cast<size_t>(textures.runs[r + 1].first) : count;
    for (size_t t = first; t < last; ++t) tile.material_of[t] = textures.runs[r].material;
  }
  for (const Triangle& corners : textures.corners) {
    PictureTile::Corners& uv = tile.coordinates.emplace_back();
    for (size_t k = 0; k < 3; ++k) {
      if (corners[k] >= 0) uv[k] = textures.coordinates[static_cast<size_t>(corners[k])];
    }
  }
  return absl::OkStatus();
}

// The finest level of a tree.
absl::StatusOr<PictureTile> ReadTreePicture(const std::string& path, const std::string& pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tree, ReadTileTree(pack, name));
  TreeLevel finest = LevelOf(tree, tree.levels - 1);
  PictureTile tile;
  for (const TreeLevel::Part& part : finest.parts) {
    const int32_t f = tree.pieces[part.piece].file;
    const TreeFile& file = tree.files[f];
    for (const int32_t g : part.geometries) {
      const TreeGeometry& geometry = file.geometries[g];
      const bool has_image = geometry.texture >= 0;
      if (has_image) tile.materials.push_back({FileBesideTile(path, tree.packed[f].name), geometry.texture, {}});
      const int32_t material = has_image ? static_cast<int32_t>(tile.materials.size()) - 1 : -1;
      tile.material_of.insert(tile.material_of.end(), static_cast<size_t>(geometry.triangle_count), material);
      for (int32_t t = 0; t < geometry.triangle_count; ++t) {
        PictureTile::Corners& uv = tile.coordinates.emplace_back();
        for (size_t k = 0; k < 3; ++k) uv[k] = file.uv[file.triangles[geometry.first_triangle + t][k]];
      }
    }
  }
  tile.faces.mesh = std::move(finest.mesh);
  return tile;
}

}  // namespace

absl::StatusOr<PictureTile> ReadPictureTile(const std::string& root, const std::string& path, const TileFrame& frame) {
  const std::string name = absl::StrCat(root, "/", path);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(name));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTileBytes(name, frame));
  if (format == MeshFormat::kTileTree) return ReadTreePicture(path, bytes, name);
  PictureTile tile;
  if (format == MeshFormat::kObj) {
    TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, name, NoFaces::kAccept));
    tile.faces.mesh = std::move(obj.file.mesh);
    TILEMEND_RETURN_IF_ERROR(AddObjLook(root, path, obj.textures, tile));
    return tile;
  }
  TILEMEND_ASSIGN_OR_RETURN(MeshFile file, ParseMesh(format, bytes, name, NoFaces::kAccept));
  tile.faces.mesh = std::move(file.mesh);
  tile.material_of.assign(tile.faces.mesh.triangles.size(), -1);
  if (format == MeshFormat::kPly) {
    std::vector<int32_t> all(tile.faces.mesh.points.size());
    std::iota(all.begin(), all.end(), 0);
    TILEMEND_ASSIGN_OR_RETURN(tile.vertex_colours, PlyVertexColours(bytes, all, name));
  }
  return tile;
}

}  // namespace tilemend
