#include "coordinator/jobs/delivery_entry.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/tiles3d/new_tileset.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "common/codec/tiles3d/tileset_layout.h"
#include "common/gis/lon_lat.h"
#include "common/grid/delivery_paths.h"
#include "common/records/output_names.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

bool IsDeliveredAsTileset(const SceneTile& tile) { return IsTileset(tile.delivered); }

constexpr double kStep = 10;  // metres, over which axes are measured

// The middle of a cell and points a step to the east and to the north of it, in the CRS.
void AddPoints(const Scene& scene, const Point2& middle, std::vector<Point2>& points) {
  const Point2 at = scene.origin.head<2>() + middle;
  points.insert(points.end(), {at, at + Point2(kStep, 0), at + Point2(0, kStep)});
}

Point2 MiddleOf(const Scene& scene, const Point2& cell) {
  return scene.grid.corner + scene.grid.cell_size.cwiseProduct(cell);
}

Point3 OnEarth(const Point2& degrees, double height) {
  const Point2 radians = degrees * (std::numbers::pi / 180);
  return EarthCentred({radians.x(), radians.y(), height});
}

// From the scene's frame to the Earth-centred one near `middle`, by the degrees of its three points.
Eigen::Matrix4d PlaneAt(const Scene& scene, const Point2& middle, const Point2* degrees) {
  const double height = scene.origin.z();
  const Point3 at = OnEarth(degrees[0], height);
  const Point2 radians = degrees[0] * (std::numbers::pi / 180);
  Eigen::Matrix4d plane = Eigen::Matrix4d::Identity();
  plane.block<3, 1>(0, 0) = (OnEarth(degrees[1], height) - at) / kStep;
  plane.block<3, 1>(0, 1) = (OnEarth(degrees[2], height) - at) / kStep;
  plane.block<3, 1>(0, 2) = AxesAt({radians.x(), radians.y(), height}).col(2);
  plane.block<3, 1>(0, 3) = at - plane.topLeftCorner<3, 3>() * Point3(middle.x(), middle.y(), 0);
  return plane;
}

Eigen::Matrix4d RootAt(const Scene& scene, const Point2& degrees) {
  const Point2 radians = degrees * (std::numbers::pi / 180);
  Eigen::Matrix4d root = Eigen::Matrix4d::Identity();
  root.topLeftCorner<3, 3>() = AxesAt({radians.x(), radians.y(), 0});
  root.topRightCorner<3, 1>() = OnEarth(degrees, scene.origin.z());
  return root;
}

}  // namespace

absl::StatusOr<DeliveryPlaces> PlaceDelivery(const Scene& scene) {
  DeliveryPlaces places;
  std::vector<const SceneTile*> tiles;
  for (const SceneTile& tile : scene.tiles) {
    if (IsDeliveredAsTileset(tile)) tiles.push_back(&tile);
  }
  if (tiles.empty()) return places;
  if (scene.crs.empty()) {
    for (const SceneTile* tile : tiles) places.cells[tile->cell] = Eigen::Matrix4d::Identity();
    places.warning = "the scene names no CRS: tileset.json has no place on the Earth";
    return places;
  }
  std::vector<Point2> points;
  AddPoints(scene, MiddleOf(scene, {scene.cols / 2.0, scene.rows / 2.0}), points);
  const auto middle_of = [&](const CellId& cell) { return MiddleOf(scene, {cell.col + 0.5, cell.row + 0.5}); };
  for (const SceneTile* tile : tiles) AddPoints(scene, middle_of(tile->cell), points);
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<Point2> degrees, LonLatOf(scene.crs, points));
  places.root = RootAt(scene, degrees[0]);
  for (size_t t = 0; t < tiles.size(); ++t) {
    places.cells[tiles[t]->cell] = PlaneAt(scene, middle_of(tiles[t]->cell), &degrees[3 * (t + 1)]);
  }
  return places;
}

absl::StatusOr<std::string> DeliveryEntry(const Scene& scene, const DeliveryPlaces& places, const std::string& out) {
  std::vector<EntryPart> parts;
  for (const SceneTile& tile : scene.tiles) {
    if (!IsDeliveredAsTileset(tile)) continue;
    TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(out, "/", tile.delivered)));
    if (kind != PathKind::kFile) continue;
    parts.push_back({tile.delivered, places.cells.at(tile.cell)});
  }
  if (parts.empty()) return absl::InvalidArgumentError(absl::StrCat(out, ": no tile was written"));
  return NewEntry(out, parts, places.root);
}

absl::StatusOr<std::string> MetadataOf(const Scene& scene) {
  const std::string from = absl::StrCat(scene.root, "/", kMetadataFile);
  TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(from));
  if (kind == PathKind::kFile) return ReadFile(from);
  const bool is_osgb = std::any_of(scene.tiles.begin(), scene.tiles.end(),
                                   [](const SceneTile& tile) { return DeliveryFormatOf(tile.delivered) == "osgb"; });
  return is_osgb ? MetadataXml(scene) : "";
}

namespace {

// What says where a folder of photogrammetry tiles lies.
absl::Status CarryMetadata(const Scene& scene, OutputFolder& output) {
  const std::string from = absl::StrCat(scene.root, "/", kMetadataFile);
  const auto look = LookAt(from);
  if (IsObjectPath(from) && !look.ok() && !absl::IsNotFound(look.status())) return look.status();
  if (!look.ok() || look->kind != PathKind::kFile) return absl::OkStatus();
  output.files().Adopt({kMetadataFile});
  return CarryFile(from, absl::StrCat(output.path(), "/", kMetadataFile), Carry::kCopy);
}

// The tileset that names those of the tiles, with volumes that hold what they have now.
absl::Status WriteTileset(const Scene& scene, OutputFolder& output) {
  if (scene.tileset.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, GrownEntry(scene.root, scene.tileset, output.path()));
  output.files().Adopt({scene.tileset});
  return WriteFileAtomically(absl::StrCat(output.path(), "/", scene.tileset), text);
}

absl::Status WriteText(const char* name, const std::string& text, OutputFolder& output) {
  output.files().Adopt({name});
  return WriteFileAtomically(absl::StrCat(output.path(), "/", name), text);
}

// The scene that the delivered tiles are, with the tileset of those that are 3D Tiles. That says where they lie on the
// Earth, but not the cells, the area and the CRS.
absl::Status WriteDelivery(const Scene& scene, OutputFolder& output) {
  TILEMEND_ASSIGN_OR_RETURN(const DeliveryPlaces places, PlaceDelivery(scene));
  TILEMEND_ASSIGN_OR_RETURN(Scene delivered, DeliveredScene(scene, output.path()));
  if (places.cells.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string metadata, MetadataOf(scene));
    if (!metadata.empty()) TILEMEND_RETURN_IF_ERROR(WriteText(kMetadataFile, metadata, output));
  } else {
    TILEMEND_ASSIGN_OR_RETURN(const std::string entry, DeliveryEntry(scene, places, output.path()));
    TILEMEND_RETURN_IF_ERROR(WriteText(kEntryFile, entry, output));
    delivered.tileset = kEntryFile;
  }
  return WriteFileAtomically(absl::StrCat(output.path(), "/", kSceneFile), SceneJson(delivered));
}

}  // namespace

absl::Status WriteScene(const Scene& scene, OutputFolder& output) {
  if (IsDelivered(scene)) return WriteDelivery(scene, output);
  TILEMEND_ASSIGN_OR_RETURN(const Scene filled, FilledScene(scene, output.path()));
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(absl::StrCat(output.path(), "/", kSceneFile), SceneJson(filled)));
  TILEMEND_RETURN_IF_ERROR(CarryMetadata(scene, output));
  return WriteTileset(scene, output);
}

}  // namespace tilemend
