#include "worker/service/delivery_stage.h"

#include <filesystem>
#include <utility>

#include "common/util/status_macros.h"
#include "worker/delivery/deliver.h"

namespace tilemend {
namespace {

absl::StatusOr<DeliveryTile> TileOf(const v1::AssembleInput& input, const AssembledTile& tile) {
  const std::string& path = input.tile().path();
  if (path.empty()) {
    std::vector<ColourRun> runs;
    for (const FilledRun& run : tile.patch->runs) runs.push_back({run.first, run.colour});
    return DeliveryOfColours({tile.patch->patch.new_points, tile.patch->patch.triangles}, runs);
  }
  const ObjBeside beside = {input.tile().root(), path, tile.materials, tile.image};
  return DeliveryOf(tile.bytes, beside, input.output_format(), tile.new_geometries);
}

}  // namespace

absl::StatusOr<Delivered> DeliverTile(const v1::AssembleInput& input, const AssembledTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(DeliveryTile delivery, TileOf(input, tile));
  const DeliveryTarget target = {
      .format = input.output_format(),
      .stem = std::filesystem::path(input.output()).stem().string(),
      .origin = DeliveryOrigin(input.tile().path(), {input.x_middle(), input.y_middle()}),
  };
  Delivered result;
  TILEMEND_ASSIGN_OR_RETURN(result.files, Deliver(delivery, target));
  result.warnings = std::move(delivery.warnings);
  return result;
}

}  // namespace tilemend
