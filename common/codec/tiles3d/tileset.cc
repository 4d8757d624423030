#include "common/codec/tiles3d/tileset.h"

#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>

#include "absl/strings/str_cat.h"
#include "common/codec/gltf/json_view.h"
#include "common/codec/tiles3d/content_uri.h"
#include "common/util/files.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// Required extensions that say nothing about where geometry is.
constexpr const char* kKnownExtensions[] = {"3DTILES_batch_table_hierarchy", "3DTILES_bounding_volume_S2",
                                            "3DTILES_content_gltf", "3DTILES_metadata"};

struct VolumeKind {
  const char* key;
  BoundingVolume::Kind kind;
  size_t numbers;
};
constexpr VolumeKind kVolumeKinds[] = {{"box", BoundingVolume::Kind::kBox, 12},
                                       {"region", BoundingVolume::Kind::kRegion, 6},
                                       {"sphere", BoundingVolume::Kind::kSphere, 4}};

std::string Lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

absl::StatusOr<BoundingVolume> ReadVolume(const JsonView& volume) {
  for (const VolumeKind& kind : kVolumeKinds) {
    const std::optional<JsonView> numbers = volume.Find(kind.key);
    if (!numbers) continue;
    BoundingVolume result;
    result.kind = kind.kind;
    TILEMEND_ASSIGN_OR_RETURN(result.numbers, numbers->AsNumbers(kind.numbers));
    return result;
  }
  return volume.Error("expected a box, a region or a sphere");
}

absl::StatusOr<Eigen::Matrix4d> ReadTransform(const JsonView& tile) {
  const std::optional<JsonView> transform = tile.Find("transform");
  if (!transform) return Eigen::Matrix4d(Eigen::Matrix4d::Identity());
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> numbers, transform->AsNumbers(16));
  return Eigen::Matrix4d(numbers.data());  // both store columns
}

absl::StatusOr<GltfUpAxis> ReadAsset(const JsonView& root) {
  TILEMEND_ASSIGN_OR_RETURN(const JsonView asset, root.Get("asset"));
  TILEMEND_ASSIGN_OR_RETURN(const std::string version, asset.TextOr("version", ""));
  if (version != "1.0" && version != "1.1") {
    return asset.Error(
        absl::StrCat("3D Tiles ", Printable(Shortened(version, 20)), " is not read; expected 1.0 or 1.1"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string up, asset.TextOr("gltfUpAxis", "Y"));
  if (Lower(up) == "x") return GltfUpAxis::kX;
  if (Lower(up) == "z") return GltfUpAxis::kZ;
  if (Lower(up) == "y") return GltfUpAxis::kY;
  return asset.Error("gltfUpAxis is not X, Y or Z");
}

absl::Status CheckRequiredExtensions(const JsonView& root) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> required, root.Elements("extensionsRequired"));
  for (const JsonView& element : required) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string extension, element.AsText());
    if (std::ranges::find(kKnownExtensions, extension) == std::end(kKnownExtensions)) {
      return element.Error(absl::StrCat("the tileset requires the extension ", Printable(Shortened(extension, 80)),
                                        ", which is not read"));
    }
  }
  return absl::OkStatus();
}

// The content of a tile; none if it has none. Several are refused.
absl::StatusOr<std::optional<JsonView>> ContentOf(const JsonView& tile) {
  if (tile.Find("implicitTiling") || tile.Extension("3DTILES_implicit_tiling")) {
    return tile.Error("implicit tiling is not read");
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> contents, tile.Elements("contents"));
  if (contents.size() > 1 || tile.Extension("3DTILES_multiple_contents")) {
    return tile.Error("several contents in a tile are not read");
  }
  if (!contents.empty()) return contents.front();
  return tile.Find("content");
}

class TilesetReader {
 public:
  TilesetReader(const TilesetSource& source, const TilesetLimits& limits) : source_(source), limits_(limits) {}

  absl::StatusOr<Tileset> Read(const std::string& entry) && {
    TILEMEND_RETURN_IF_ERROR(ReadDocument(entry, {}));
    return std::move(tileset_);
  }

 private:
  // What a tile takes from those above it.
  struct Above {
    int32_t parent = -1;
    int32_t depth = 0;
    int32_t level = 0;
    bool adds = false;  // refinement ADD
    Eigen::Matrix4d to_root = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d in_root = Eigen::Matrix4d::Identity();
  };

  absl::Status ReadDocument(const std::string& file, const Above& above) {
    if (static_cast<int64_t>(tileset_.documents.size()) >= limits_.max_documents) {
      return absl::ResourceExhaustedError(
          absl::StrCat(file, ": the tileset has more than ", limits_.max_documents, " files"));
    }
    TILEMEND_ASSIGN_OR_RETURN(std::string text, source_.Read(file));
    if (static_cast<int64_t>(text.size()) > limits_.max_document_bytes) {
      return absl::ResourceExhaustedError(absl::StrCat(file, ": over ", limits_.max_document_bytes, " bytes"));
    }
    files_.insert(file);
    TILEMEND_ASSIGN_OR_RETURN(const OrderedJson json, ParseOrderedJson(text, 0, file));
    const JsonView root(json, file);
    const auto document = static_cast<int32_t>(tileset_.documents.size());
    tileset_.documents.push_back({.file = file, .text = std::move(text), .up = GltfUpAxis::kY});
    TILEMEND_ASSIGN_OR_RETURN(tileset_.documents.back().up, ReadAsset(root));
    TILEMEND_RETURN_IF_ERROR(CheckRequiredExtensions(root));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView tile, root.Get("root"));
    return ReadTile(tile, document, above);
  }

  absl::Status ReadTile(const JsonView& view, int32_t document, const Above& above) {
    if (static_cast<int64_t>(tileset_.tiles.size()) >= limits_.max_tiles || above.depth >= limits_.max_depth) {
      return absl::ResourceExhaustedError(absl::StrCat(FileOf(document), ": JSON ", view.path(), ": more than ",
                                                       limits_.max_tiles, " tiles, or deeper than ",
                                                       limits_.max_depth));
    }
    const auto index = static_cast<int32_t>(tileset_.tiles.size());
    tileset_.tiles.emplace_back();
    if (above.parent >= 0) tileset_.tiles[static_cast<size_t>(above.parent)].children.push_back(index);
    TilesetTile tile;
    tile.document = document;
    tile.path = view.path();
    tile.parent = above.parent;
    tile.level = above.level;
    TILEMEND_RETURN_IF_ERROR(ReadOwn(view, above, tile));
    TILEMEND_ASSIGN_OR_RETURN(const std::optional<JsonView> content, ContentOf(view));
    if (content) TILEMEND_RETURN_IF_ERROR(ReadContent(*content, document, tile));
    const std::string external = limits_.follows ? tile.external : "";
    Above below{.parent = index,
                .depth = above.depth + 1,
                .level = above.level + (tile.content.empty() ? 0 : 1),
                .adds = above.adds,
                .to_root = tile.to_root,
                .in_root = tile.in_root};
    TILEMEND_ASSIGN_OR_RETURN(below.adds, ReadRefine(view, above));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<JsonView> children, view.Elements("children"));
    if (below.adds && !tile.content.empty() && !children.empty()) {
      return view.Error("refinement ADD is not read; expected REPLACE");
    }
    tileset_.tiles[static_cast<size_t>(index)] = std::move(tile);
    for (const JsonView& child : children) TILEMEND_RETURN_IF_ERROR(ReadTile(child, document, below));
    return external.empty() ? absl::OkStatus() : ReadDocument(external, below);
  }

  static absl::StatusOr<bool> ReadRefine(const JsonView& view, const Above& above) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string refine, view.TextOr("refine", above.adds ? "ADD" : "REPLACE"));
    if (Lower(refine) == "add") return true;
    if (Lower(refine) == "replace") return false;
    return view.Error("refine is not REPLACE");
  }

  static absl::Status ReadOwn(const JsonView& view, const Above& above, TilesetTile& tile) {
    TILEMEND_ASSIGN_OR_RETURN(const JsonView volume, view.Get("boundingVolume"));
    TILEMEND_ASSIGN_OR_RETURN(tile.volume, ReadVolume(volume));
    TILEMEND_ASSIGN_OR_RETURN(const JsonView error, view.Get("geometricError"));
    TILEMEND_ASSIGN_OR_RETURN(tile.geometric_error, error.AsNumber());
    TILEMEND_ASSIGN_OR_RETURN(const Eigen::Matrix4d transform, ReadTransform(view));
    tile.to_root = above.to_root * transform;
    if (above.parent >= 0) tile.in_root = above.in_root * transform;
    const Eigen::Matrix3d linear = tile.to_root.topLeftCorner<3, 3>();
    if (!tile.to_root.allFinite() || !Eigen::FullPivLU<Eigen::Matrix3d>(linear).isInvertible()) {
      return view.Error("the transform cannot be inverted");
    }
    return absl::OkStatus();
  }

  absl::Status ReadContent(const JsonView& content, int32_t document, TilesetTile& tile) {
    const std::optional<JsonView> named = content.Find("uri") ? content.Find("uri") : content.Find("url");
    if (!named) return content.Error("expected a member \"uri\"");
    TILEMEND_ASSIGN_OR_RETURN(const std::string uri, named->AsText());
    absl::StatusOr<std::string> path = ResolveContentUri(FileOf(document), uri);
    if (!path.ok()) return named->Error(std::string(path.status().message()));
    if (!files_.insert(*path).second) {
      return named->Error(
          absl::StrCat("two tiles, or a tileset and itself, refer to ", Printable(Shortened(*path, 200))));
    }
    if (const std::optional<JsonView> volume = content.Find("boundingVolume")) {
      TILEMEND_ASSIGN_OR_RETURN(tile.content_volume, ReadVolume(*volume));
    }
    const std::string extension = Lower(path->substr(std::min(path->rfind('.'), path->size())));
    if (extension == ".json") {
      tile.external = *std::move(path);
    } else if (extension == ".glb" || extension == ".b3dm") {
      tile.content = *std::move(path);
    } else {
      return named->Error("models are .glb or .b3dm files, external tilesets are .json");
    }
    return absl::OkStatus();
  }

  const std::string& FileOf(int32_t document) const { return tileset_.documents[static_cast<size_t>(document)].file; }

  const TilesetSource& source_;
  TilesetLimits limits_;
  Tileset tileset_;
  std::set<std::string> files_;  // that a tile names, and the entry
};

bool SetVolume(const BoundingVolume& volume, OrderedJson& json) {
  for (const VolumeKind& kind : kVolumeKinds) {
    if (kind.kind != volume.kind) continue;
    OrderedJson& numbers = json[kind.key];
    if (numbers.get<std::vector<double>>() == volume.numbers) return false;
    numbers = volume.numbers;
    return true;
  }
  return false;
}

Point3 Transformed(const Eigen::Matrix4d& matrix, const Point3& point) {
  return matrix.topLeftCorner<3, 3>() * point + matrix.topRightCorner<3, 1>();
}

// The volume of a tile whose frame `from_root` leads to.
void Grow(const std::vector<Point3>& in_root, const Eigen::Matrix4d& from_root, BoundingVolume& volume) {
  if (volume.kind == BoundingVolume::Kind::kRegion) {
    volume = GrownVolume(volume, in_root);
    return;
  }
  std::vector<Point3> points;
  points.reserve(in_root.size());
  for (const Point3& point : in_root) points.push_back(Transformed(from_root, point));
  volume = GrownVolume(volume, points);
}

}  // namespace

absl::StatusOr<std::string> FolderSource::Read(const std::string& file) const {
  const std::filesystem::path folder = RealPath(folder_);
  const std::filesystem::path path = folder / file;
  if (!IsBelow(folder, RealPath(path))) {
    return absl::OutOfRangeError(absl::StrCat(path.string(), ": it leads out of the folder ", folder.string()));
  }
  return ReadFile(path.string());
}

absl::StatusOr<Tileset> ReadTileset(const TilesetSource& source, const std::string& entry,
                                    const TilesetLimits& limits) {
  return TilesetReader(source, limits).Read(entry);
}

void GrowVolumes(Tileset& tileset, int32_t tile, const std::vector<Point3>& points) {
  if (points.empty()) return;
  TilesetTile& own = tileset.tiles[static_cast<size_t>(tile)];
  std::vector<Point3> in_root;
  in_root.reserve(points.size());
  for (const Point3& point : points) in_root.push_back(Transformed(own.to_root, point));
  if (own.content_volume) Grow(in_root, own.to_root.inverse(), *own.content_volume);
  for (int32_t i = tile; i >= 0; i = tileset.tiles[static_cast<size_t>(i)].parent) {
    TilesetTile& above = tileset.tiles[static_cast<size_t>(i)];
    Grow(in_root, above.to_root.inverse(), above.volume);
  }
}

std::string WriteTilesetDocument(const Tileset& tileset, int32_t document) {
  const std::string& text = tileset.documents[static_cast<size_t>(document)].text;
  OrderedJson json = OrderedJson::parse(text, nullptr, /*allow_exceptions=*/false);
  bool is_changed = false;
  for (const TilesetTile& tile : tileset.tiles) {
    if (tile.document != document) continue;
    OrderedJson& node = json[OrderedJson::json_pointer(tile.path)];
    if (SetVolume(tile.volume, node["boundingVolume"])) is_changed = true;
    if (!tile.content_volume) continue;
    OrderedJson& content = node.contains("contents") ? node["contents"][0] : node["content"];
    if (SetVolume(*tile.content_volume, content["boundingVolume"])) is_changed = true;
  }
  if (!is_changed) return text;
  constexpr int kIndent = 2;
  const bool has_lines = text.find('\n') != std::string::npos;
  return json.dump(has_lines ? kIndent : -1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace tilemend
