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
#include "worker/service/tile_reading.h"

namespace tilemend {
namespace {

absl::StatusOr<DeliveryTile> DeliveryOf(const v1::AssembleInput& input, const AssembledTile& tile) {
  const std::string& path = input.tile().path();
  if (path.empty()) {
    std::vector<ColourRun> runs;
    for (const FilledRun& run : tile.patch->runs) runs.push_back({run.first, run.colour});
    return DeliveryOfColours({tile.patch->patch.new_points, tile.patch->patch.triangles}, runs);
  }
  if (!IsTileTree(path)) return DeliveryOfObj(tile.bytes, {input.tile().root(), path, tile.materials, tile.image});
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tree, ReadTileTree(tile.bytes, PathOf(input.tile())));
  return DeliveryOfTree(tree, input.output_format() == "obj" ? DeliveryLevels::kFinest : DeliveryLevels::kAll);
}

// Vertices of OSGB tiles are float32 values and stay as they are.
Point3 OriginFor(const v1::AssembleInput& input) {
  if (IsTileTree(input.tile().path())) return Point3::Zero();
  return {std::round(input.x_middle()), std::round(input.y_middle()), 0};
}

}  // namespace

absl::StatusOr<Delivered> DeliverTile(const v1::AssembleInput& input, const AssembledTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(DeliveryTile delivery, DeliveryOf(input, tile));
  if (input.output_format() == "3dtiles") KeepGltfImages(delivery);
  const std::string stem = std::filesystem::path(input.output()).stem().string();
  Delivered result;
  result.warnings = std::move(delivery.warnings);
  if (input.output_format() == "obj") {
    result.files = ObjFilesOf(delivery, stem);
  } else if (input.output_format() == "3dtiles") {
    TILEMEND_ASSIGN_OR_RETURN(result.files, TilesetFilesOf(delivery, stem, OriginFor(input)));
  } else {
    return absl::InvalidArgumentError(absl::StrCat("tiles are not written as ", input.output_format()));
  }
  return result;
}

}  // namespace tilemend
