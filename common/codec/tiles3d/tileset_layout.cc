#include "common/codec/tiles3d/tileset_layout.h"

#include <Eigen/Core>
#include <algorithm>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "common/codec/tiles3d/tileset.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// One file of a tileset.
absl::StatusOr<Tileset> ReadAlone(const std::string& folder, const std::string& entry) {
  auto tileset = ReadTileset(FolderSource(folder), entry, {.follows = false});
  // What cannot be opened is named with its folder already.
  if (tileset.ok() || !absl::IsInvalidArgument(tileset.status())) return tileset;
  return absl::InvalidArgumentError(absl::StrCat(folder, "/", std::string(tileset.status().message())));
}

// Whether a tileset that another names is there. In an object store each look takes a request: what is missing shows
// when it is read.
absl::Status CheckIsThere(const std::string& folder, const std::string& entry, const std::string& external) {
  if (IsObjectPath(folder)) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(folder, "/", external)));
  if (kind == PathKind::kFile) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(folder, "/", entry, ": names ", external,
                                          ", which is not there; put it back, or export the tileset again"));
}

// Why the tilesets at these paths are no parts of their own; empty if they are.
std::string WhyNotApart(const Tileset& tileset, const std::vector<TilesetPlace>& places) {
  for (const TilesetTile& tile : tileset.tiles) {
    if (!tile.content.empty()) return absl::StrCat("it has models of its own, such as ", tile.content);
  }
  std::vector<std::string> folders;
  for (const TilesetPlace& place : places) {
    folders.push_back(FileBesideTile(place.path, ""));
    if (folders.back().empty()) return absl::StrCat(place.path, " lies beside it");
  }
  std::ranges::sort(folders);
  const auto nested =
      std::ranges::adjacent_find(folders, [](const std::string& a, const std::string& b) { return b.starts_with(a); });
  return nested == folders.end() ? "" : absl::StrCat("two tilesets lie in ", *nested);
}

// Points whose hull holds a volume, in the frame that a tile's is the one of the root's parent of.
std::vector<Point3> CornersOf(const TilesetTile& root) {
  const std::vector<double>& n = root.volume.numbers;
  std::vector<Point3> corners;
  const bool is_region = root.volume.kind == BoundingVolume::Kind::kRegion;
  for (int k = 0; k < 8; ++k) {
    const auto at = [&](int bit) { return (k >> bit & 1) == 0 ? -1.0 : 1.0; };
    if (is_region) {
      corners.push_back(EarthCentred({n[at(0) < 0 ? 0 : 2], n[at(1) < 0 ? 1 : 3], n[at(2) < 0 ? 4 : 5]}));
      continue;
    }
    Point3 corner(n[0], n[1], n[2]);
    for (int axis = 0; axis < 3; ++axis) {
      const Point3 half = root.volume.kind == BoundingVolume::Kind::kBox
                              ? Point3(n[3 + 3 * axis], n[4 + 3 * axis], n[5 + 3 * axis])
                              : Point3(n[3] * Point3::Unit(axis));
      corner += at(axis) * half;
    }
    corners.push_back(Moved(root.to_root, corner));
  }
  return corners;
}

}  // namespace

absl::StatusOr<TilesetLayout> ReadTilesetLayout(const std::string& folder, const std::string& entry, double turn) {
  TILEMEND_ASSIGN_OR_RETURN(const Tileset tileset, ReadAlone(folder, entry));
  const TilesetFrame frame = FrameOf(tileset, turn);
  TilesetLayout layout{frame.crs, frame.height, {}, ""};
  for (const TilesetTile& tile : tileset.tiles) {
    if (tile.external.empty()) continue;
    TILEMEND_RETURN_IF_ERROR(CheckIsThere(folder, entry, tile.external));
    const Eigen::Matrix4d to_scene = ToScene(frame, tile);
    layout.tilesets.push_back({tile.external, {to_scene.data(), to_scene.data() + to_scene.size()}});
  }
  std::ranges::sort(layout.tilesets, {}, &TilesetPlace::path);
  const std::string why = WhyNotApart(tileset, layout.tilesets);
  if (!layout.tilesets.empty() && why.empty()) return layout;
  if (!layout.tilesets.empty()) {
    layout.warning = absl::StrCat(folder, "/", entry, ": its tilesets are no tiles of their own: ", why);
  }
  layout.tilesets = {{entry, {}}};
  return layout;
}

absl::StatusOr<std::string> GrownEntry(const std::string& folder, const std::string& entry,
                                       const std::string& written) {
  TILEMEND_ASSIGN_OR_RETURN(Tileset tileset, ReadAlone(folder, entry));
  for (size_t t = 0; t < tileset.tiles.size(); ++t) {
    const std::string external = tileset.tiles[t].external;
    if (external.empty()) continue;
    TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(written, "/", external)));
    if (kind != PathKind::kFile) continue;
    TILEMEND_ASSIGN_OR_RETURN(const Tileset before, ReadAlone(folder, external));
    TILEMEND_ASSIGN_OR_RETURN(const Tileset after, ReadAlone(written, external));
    if (before.tiles[0].volume == after.tiles[0].volume) continue;
    GrowVolumes(tileset, static_cast<int32_t>(t), CornersOf(after.tiles[0]));
  }
  return WriteTilesetDocument(tileset, 0);
}

}  // namespace tilemend
