#include "worker/service/delivery_stage.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "worker/delivery/delivery_tile.h"
#include "worker/delivery/obj_delivery.h"
#include "worker/delivery/osgb_delivery.h"
#include "worker/delivery/ply_delivery.h"
#include "worker/service/tile_reading.h"

namespace tilemend {
namespace {

// Whether files of this format have levels of detail.
bool HasLevels(std::string_view format) { return format == "3dtiles" || format == "osgb"; }

absl::StatusOr<DeliveryTile> DeliveryOf(const v1::AssembleInput& input, const AssembledTile& tile) {
  const std::string& path = input.tile().path();
  if (path.empty()) {
    std::vector<ColourRun> runs;
    for (const FilledRun& run : tile.patch->runs) runs.push_back({run.first, run.colour});
    return DeliveryOfColours({tile.patch->patch.new_points, tile.patch->patch.triangles}, runs);
  }
  if (!IsTileTree(path)) return DeliveryOfObj(tile.bytes, {input.tile().root(), path, tile.materials, tile.image});
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tree, ReadTileTree(tile.bytes, PathOf(input.tile())));
  const DeliveryLevels levels = HasLevels(input.output_format()) ? DeliveryLevels::kAll : DeliveryLevels::kFinest;
  return DeliveryOfTree(tree, levels, tile.new_geometries);
}

// Vertices of OSGB tiles are float32 values and stay as they are.
Point3 OriginFor(const v1::AssembleInput& input) {
  if (IsTileTree(input.tile().path())) return Point3::Zero();
  return {std::round(input.x_middle()), std::round(input.y_middle()), 0};
}

absl::StatusOr<std::vector<DeliveryFile>> FilesOf(const DeliveryTile& tile, const v1::AssembleInput& input) {
  const std::string& format = input.output_format();
  const std::string stem = std::filesystem::path(input.output()).stem().string();
  if (format == "3dtiles") return TilesetFilesOf(tile, stem, OriginFor(input));
  if (format == "osgb") return OsgbFilesOf(tile, stem);
  if (format == "obj") return ObjFilesOf(tile, stem);
  if (format == "ply") return PlyFilesOf(tile, stem);
  return absl::InvalidArgumentError(absl::StrCat("tiles are not written as ", format));
}

}  // namespace

absl::StatusOr<Delivered> DeliverTile(const v1::AssembleInput& input, const AssembledTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(DeliveryTile delivery, DeliveryOf(input, tile));
  if (HasLevels(input.output_format())) KeepJpegAndPng(delivery);
  // A PLY has images or colours.
  if (input.output_format() != "ply" || !delivery.images.empty()) DropVertexColours(delivery);
  Delivered result;
  TILEMEND_ASSIGN_OR_RETURN(result.files, FilesOf(delivery, input));
  result.warnings = std::move(delivery.warnings);
  return result;
}

}  // namespace tilemend
