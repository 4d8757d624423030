#include "worker/delivery/deliver.h"

#include <cmath>

#include "absl/strings/str_cat.h"
#include "common/codec/tree/tile_tree.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "worker/delivery/obj_delivery.h"
#include "worker/delivery/osgb_delivery.h"

namespace tilemend {

absl::StatusOr<DeliveryTile> DeliveryOf(std::string_view bytes, const ObjBeside& beside, const std::string& format,
                                        std::span<const int32_t> new_geometries) {
  if (!IsTileTree(beside.path)) return DeliveryOfObj(bytes, beside);
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tree, ReadTileTree(bytes, absl::StrCat(beside.root, "/", beside.path)));
  const DeliveryLevels levels = HasLevelsOfDetail(format) ? DeliveryLevels::kAll : DeliveryLevels::kFinest;
  return DeliveryOfTree(tree, levels, new_geometries);
}

Point3 DeliveryOrigin(std::string_view path, const Point2& middle) {
  if (IsTileTree(path)) return Point3::Zero();
  return {std::round(middle.x()), std::round(middle.y()), 0};
}

absl::StatusOr<std::vector<DeliveryFile>> Deliver(DeliveryTile& tile, const DeliveryTarget& target) {
  if (HasLevelsOfDetail(target.format)) KeepJpegAndPng(tile);
  if (target.format != "ply" || HasImages(tile, target.ply)) DropVertexColours(tile);
  if (target.format == "3dtiles") return TilesetFilesOf(tile, target.stem, target.origin);
  if (target.format == "osgb") return OsgbFilesOf(tile, target.stem);
  if (target.format == "obj") return ObjFilesOf(tile, target.stem);
  if (target.format == "ply") return PlyFilesOf(tile, target.stem, target.ply);
  return absl::InvalidArgumentError(absl::StrCat("tiles are not written as ", target.format));
}

}  // namespace tilemend
