#include "common/codec/tiles3d/tileset_tree.h"

#include <Eigen/LU>
#include <map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/tiles3d/tileset.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

constexpr double kMostMetres = 1e9;  // as in other formats

using FileNumbers = std::map<std::string, int32_t, std::less<>>;

FileNumbers NumbersOf(const std::vector<PackedFile>& packed) {
  FileNumbers numbers;
  for (size_t f = 0; f < packed.size(); ++f) numbers.emplace(packed[f].name, static_cast<int32_t>(f));
  return numbers;
}

// The files of a pack by their names.
class PackSource : public TilesetSource {
 public:
  explicit PackSource(const std::vector<PackedFile>& packed) : packed_(packed), numbers_(NumbersOf(packed)) {}

  absl::StatusOr<std::string> Read(const std::string& file) const override {
    const auto at = numbers_.find(file);
    if (at == numbers_.end()) return absl::NotFoundError(absl::StrCat(file, ": no such file"));
    return std::string(packed_[static_cast<size_t>(at->second)].bytes);
  }

 private:
  const std::vector<PackedFile>& packed_;
  const FileNumbers numbers_;
};

// A file of the pack in messages: beside the tile's own file, which is `name`.
std::string InFolder(const std::string& text, const std::string& name) {
  return absl::StrCat(name.substr(0, name.rfind('/') + 1), text);
}

absl::StatusOr<Tileset> ReadPackedTileset(const std::vector<PackedFile>& packed, const std::string& name) {
  if (packed.empty()) return absl::InvalidArgumentError(absl::StrCat(name, ": a tile without files"));
  auto tileset = ReadTileset(PackSource(packed), packed[0].name);
  if (tileset.ok()) return tileset;
  return absl::Status(tileset.status().code(), InFolder(std::string(tileset.status().message()), name));
}

// The frame that is in the pack, else that of the tileset.
TilesetFrame FrameOfPack(const Tileset& tileset, const std::vector<PackedFile>& packed) {
  if (packed.back().name != kFrameFile) return FrameOf(tileset);
  const TileFrame numbers = FrameIn(packed.back().bytes);
  TilesetFrame frame;
  if (!numbers.empty()) frame.from_outer = Eigen::Matrix4d(numbers.data());
  return frame;
}

// A model of the pack and where it stands.
struct PlacedModel {
  int32_t tile = 0;  // of the tileset
  int32_t file = 0;  // of the pack
  GltfUpAxis up = GltfUpAxis::kY;
  Eigen::Matrix4d to_scene;  // from the tile's frame
};

std::vector<PlacedModel> ModelsOf(const Tileset& tileset, const std::vector<PackedFile>& packed) {
  const FileNumbers numbers = NumbersOf(packed);
  const TilesetFrame frame = FrameOfPack(tileset, packed);
  std::vector<PlacedModel> models;
  for (int32_t t = 0; t < std::ssize(tileset.tiles); ++t) {
    const TilesetTile& tile = tileset.tiles[static_cast<size_t>(t)];
    const auto at = numbers.find(tile.content);
    if (tile.content.empty() || at == numbers.end()) continue;
    models.push_back({t, at->second, tileset.documents[static_cast<size_t>(tile.document)].up, ToScene(frame, tile)});
  }
  return models;
}

// Of each tile: whether one below it has a model.
std::vector<bool> HaveModelsBelow(const Tileset& tileset, const std::vector<PlacedModel>& models) {
  std::vector<bool> has_model(tileset.tiles.size()), below(tileset.tiles.size());
  for (const PlacedModel& model : models) has_model[static_cast<size_t>(model.tile)] = true;
  for (size_t t = tileset.tiles.size(); t-- > 1;) {
    if (has_model[t] || below[t]) below[static_cast<size_t>(tileset.tiles[t].parent)] = true;
  }
  return below;
}

// The nearest model above a tile, by the models of the tiles; -1 if there is none.
int32_t ModelAbove(const Tileset& tileset, int32_t tile, const std::vector<int32_t>& model_of) {
  int32_t above = tileset.tiles[static_cast<size_t>(tile)].parent;
  while (above >= 0 && model_of[static_cast<size_t>(above)] < 0)
    above = tileset.tiles[static_cast<size_t>(above)].parent;
  return above < 0 ? -1 : model_of[static_cast<size_t>(above)];
}

// The patches of an edit in the frame of the model's tile, and with its centre in that of the model.
struct LocalPatches {
  std::vector<Point3> in_tile;
  std::vector<GltfPatch> patches;
};

LocalPatches ToModel(std::vector<GltfPatch> patches, const PlacedModel& model, const Point3& origin) {
  LocalPatches local;
  const Eigen::Matrix4d to_tile = model.to_scene.inverse();
  for (GltfPatch& patch : patches) {
    patch.node = 0;
    for (Point3& point : patch.points) {
      const Point3 in_tile = Moved(to_tile, point);
      local.in_tile.push_back(in_tile);
      point = in_tile - origin;
    }
    local.patches.push_back(std::move(patch));
  }
  return local;
}

}  // namespace

absl::StatusOr<TilesetTree> ReadTilesetTree(std::string_view pack, const std::string& name) {
  TilesetTree tree;
  TILEMEND_ASSIGN_OR_RETURN(tree.packed, UnpackFiles(pack, name));
  TILEMEND_ASSIGN_OR_RETURN(const Tileset tileset, ReadPackedTileset(tree.packed, name));
  const std::vector<PlacedModel> models = ModelsOf(tileset, tree.packed);
  const std::vector<bool> below = HaveModelsBelow(tileset, models);
  std::vector<int32_t> model_of(tileset.tiles.size(), -1);
  const FileNumbers numbers = NumbersOf(tree.packed);
  for (const TilesetTile& tile : tileset.tiles) {
    if (!tile.content.empty() && !numbers.contains(tile.content)) tree.missing.push_back(tile.content);
  }
  bool is_empty = true;
  for (const PlacedModel& placed : models) {
    const PackedFile& file = tree.packed[static_cast<size_t>(placed.file)];
    const auto t = static_cast<size_t>(placed.tile);
    const TilesetTile& tile = tileset.tiles[t];
    TilesetModel& model = tree.models.emplace_back();
    model.file = placed.file;
    model.level = tile.level;
    model.is_finest = !below[t];
    model.parent = ModelAbove(tileset, placed.tile, model_of);
    model.geometric_error = model.is_finest ? 0 : tile.geometric_error;
    model_of[t] = static_cast<int32_t>(tree.models.size()) - 1;
    TILEMEND_ASSIGN_OR_RETURN(model.gltf, ReadGltf(file.bytes, placed.up, InFolder(file.name, name)));
    for (Point3& point : model.gltf.points) {
      point = Moved(placed.to_scene, model.gltf.origin + point);
      if (point.cwiseAbs().maxCoeff() <= kMostMetres) continue;
      return absl::InvalidArgumentError(
          absl::StrCat(InFolder(file.name, name), ": a vertex lies more than 1e9 m from the scene's origin"));
    }
    is_empty = is_empty && model.gltf.points.empty();
    tree.levels = std::max(tree.levels, model.level + 1);
  }
  if (is_empty) return absl::InvalidArgumentError(absl::StrCat(name, ": no vertices"));
  return tree;
}

absl::StatusOr<std::string> ChangeTilesetTree(const std::vector<PackedFile>& packed,
                                              const std::vector<TilesetEdit>& edits, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(Tileset tileset, ReadPackedTileset(packed, name));
  std::vector<PackedFile> files = packed;
  std::vector<std::string> changed(packed.size());
  for (const PlacedModel& model : ModelsOf(tileset, packed)) {
    const auto f = static_cast<size_t>(model.file);
    if (edits[f].drop.empty() && edits[f].patches.empty()) continue;
    const std::string file_name = InFolder(files[f].name, name);
    GltfEdit edit{edits[f].drop, {}};
    if (!edits[f].patches.empty()) {
      TILEMEND_ASSIGN_OR_RETURN(const GltfFile gltf, ReadGltf(files[f].bytes, model.up, file_name));
      LocalPatches local = ToModel(edits[f].patches, model, gltf.origin);
      GrowVolumes(tileset, model.tile, local.in_tile);
      edit.patches = std::move(local.patches);
    }
    TILEMEND_ASSIGN_OR_RETURN(changed[f], ChangeGltf(files[f].bytes, model.up, edit, file_name));
    files[f].bytes = changed[f];
  }
  const FileNumbers numbers = NumbersOf(packed);
  for (size_t d = 0; d < tileset.documents.size(); ++d) {
    const auto f = static_cast<size_t>(numbers.at(tileset.documents[d].file));
    changed[f] = WriteTilesetDocument(tileset, static_cast<int32_t>(d));
    files[f].bytes = changed[f];
  }
  return PackFiles(files);
}

}  // namespace tilemend
