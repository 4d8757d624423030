#include "client/checked_tile.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/face_looks.h"
#include "common/codec/mesh_file.h"
#include "common/codec/obj.h"
#include "common/codec/ply_colours.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"
#include "worker/materials/tile_look.h"

namespace tilemend {

namespace {

absl::StatusOr<CheckedTile> ReadTree(const std::string& pack, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tree, ReadTileTree(pack, name));
  CheckedTile tile;
  for (int32_t l = 0; l < tree.levels; ++l) {
    TreeLevel level = LevelOf(tree, l);
    std::vector<uint64_t> looks = TreeFaceLooks(tree, level);
    tile.coarser.push_back({std::move(level.mesh), std::move(looks)});
  }
  tile.faces = std::move(tile.coarser.back());
  tile.coarser.pop_back();
  return tile;
}

std::vector<bool> OffImage(const ObjTextures& textures) {
  const auto is_off = [&](int32_t corner) {
    const auto is_inside = [](float x) { return x >= 0 && x <= 1; };  // false if it is no number
    return corner >= 0 && !std::ranges::all_of(textures.coordinates[corner], is_inside);
  };
  std::vector<bool> off;
  for (const Triangle& corners : textures.corners) off.push_back(std::ranges::any_of(corners, is_off));
  return off;
}

absl::StatusOr<CheckedTile> ParseObjTile(const std::string& bytes, const std::string& name, ObjTextures& textures) {
  CheckedTile tile;
  TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, name, NoFaces::kAccept));
  tile.faces.mesh = std::move(obj.file.mesh);
  textures = std::move(obj.textures);
  tile.faces.looks = ObjFaceLooks(textures, tile.faces.mesh.triangles);
  tile.named = textures.libraries;
  tile.off_image = OffImage(textures);
  return tile;
}

absl::StatusOr<CheckedTile> ParseMeshTile(MeshFormat format, const std::string& bytes, const std::string& name) {
  CheckedTile tile;
  TILEMEND_ASSIGN_OR_RETURN(MeshFile file, ParseMesh(format, bytes, name, NoFaces::kAccept));
  tile.faces.mesh = std::move(file.mesh);
  if (format == MeshFormat::kPly) {
    TILEMEND_ASSIGN_OR_RETURN(tile.faces.looks, PlyFaceLooks(bytes, name));
    tile.named = PlyTextureNames(bytes);
  } else {
    tile.faces.looks.assign(tile.faces.mesh.triangles.size(), 0);
  }
  return tile;
}

void TakeLook(TileLook look, CheckedTile& tile) {
  for (const FileWitness::Lookup& lookup : look.witness.lookups) {
    bool& is_there = tile.is_there[lookup.name];
    is_there = is_there || !lookup.path.empty();
  }
  tile.files = std::move(look.files);
}

}  // namespace

bool NamesTheSame(const CheckedTile& before, const CheckedTile& after, size_t most_new) {
  return after.named.size() >= before.named.size() && after.named.size() <= before.named.size() + most_new &&
         std::equal(before.named.begin(), before.named.end(), after.named.begin());
}

std::vector<std::string> NewMissingNames(const CheckedTile& before, const CheckedTile& after) {
  std::vector<std::string> names;
  for (const auto& [name, is_there] : after.is_there) {
    if (!is_there && !before.is_there.contains(name)) names.push_back(name);
  }
  return names;
}

absl::StatusOr<CheckedTile> ParseCheckedTile(const std::string& bytes, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(name));
  if (format == MeshFormat::kTileTree) return ReadTree(bytes, name);
  ObjTextures textures;
  return format == MeshFormat::kObj ? ParseObjTile(bytes, name, textures) : ParseMeshTile(format, bytes, name);
}

absl::StatusOr<CheckedTile> ReadCheckedTile(const std::string& root, const std::string& path, const TileFrame& frame) {
  const std::string name = absl::StrCat(root, "/", path);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(name));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTileBytes(name, frame));
  if (format == MeshFormat::kTileTree) return ReadTree(bytes, name);
  CheckedTile tile;
  if (format == MeshFormat::kObj) {
    ObjTextures textures;
    TILEMEND_ASSIGN_OR_RETURN(tile, ParseObjTile(bytes, name, textures));
    TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadObjLook(root, path, textures));
    for (const ObjTextures::Run& run : textures.runs) {
      const std::string& material = textures.materials[run.material];
      if (!look.materials.contains(material)) tile.undefined.insert(material);
    }
    TakeLook(std::move(look), tile);
    return tile;
  }
  TILEMEND_ASSIGN_OR_RETURN(tile, ParseMeshTile(format, bytes, name));
  if (format == MeshFormat::kPly) {
    TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadPlyLook(root, path, bytes));
    TakeLook(std::move(look), tile);
  }
  return tile;
}

}  // namespace tilemend
