#include "common/codec/tiles3d/new_tileset.h"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "common/codec/gltf/json_view.h"
#include "common/codec/tiles3d/content_uri.h"
#include "common/codec/tiles3d/tileset.h"
#include "common/codec/tiles3d/tileset_frame.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

OrderedJson BoxJson(const Eigen::AlignedBox3d& box) {
  const Point3 middle = box.center(), half = box.sizes() / 2;
  OrderedJson numbers = OrderedJson::array();
  for (int k = 0; k < 3; ++k) numbers.push_back(middle[k]);
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 3; ++k) numbers.push_back(k == axis ? half[axis] : 0.0);
  }
  return {{"box", std::move(numbers)}};
}

OrderedJson TileJson(const NewTile& tile) {
  OrderedJson json = {{"boundingVolume", BoxJson(tile.box)}, {"geometricError", tile.geometric_error}};
  if (tile.transform) {
    json["transform"] = std::vector<double>(tile.transform->data(), tile.transform->data() + tile.transform->size());
  }
  if (!tile.file.empty()) json["content"] = {{"uri", ContentUriOf(tile.file)}};
  for (const NewTile& child : tile.children) json["children"].push_back(TileJson(child));
  return json;
}

void RaiseErrors(NewTile& tile) {
  for (NewTile& child : tile.children) {
    RaiseErrors(child);
    tile.geometric_error = std::max(tile.geometric_error, child.geometric_error);
  }
}

// The volume of a tileset's root in the frame of the root's parent.
Eigen::AlignedBox3d BoxOf(const TilesetTile& root) {
  const std::vector<double>& n = root.volume.numbers;
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8 && n.size() >= 12; ++corner) {
    Point3 point(n[0], n[1], n[2]);
    for (size_t axis = 0; axis < 3; ++axis) {
      const double side = (corner >> axis & 1) == 0 ? -1 : 1;
      point += side * Point3(n[3 + 3 * axis], n[4 + 3 * axis], n[5 + 3 * axis]);
    }
    box.extend(Moved(root.to_root, point));
  }
  return box;
}

}  // namespace

std::string NewTileset(NewTile root) {
  RaiseErrors(root);
  OrderedJson tile = TileJson(root);
  tile["refine"] = "REPLACE";
  // What is missed where nothing is drawn.
  const double error = std::max(2 * root.geometric_error, root.box.isEmpty() ? 0 : root.box.diagonal().norm());
  const OrderedJson json = {{"asset", {{"version", "1.1"}}}, {"geometricError", error}, {"root", std::move(tile)}};
  return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

absl::StatusOr<std::string> NewEntry(const std::string& folder, const std::vector<EntryPart>& parts,
                                     const std::optional<Eigen::Matrix4d>& root) {
  NewTile entry;
  entry.transform = root;
  const Eigen::Matrix4d to_root = root ? Eigen::Matrix4d(root->inverse()) : Eigen::Matrix4d::Identity();
  for (const EntryPart& part : parts) {
    TILEMEND_ASSIGN_OR_RETURN(const Tileset tileset, ReadTileset(FolderSource(folder), part.file, {.follows = false}));
    NewTile child{part.file, tileset.tiles[0].geometric_error, BoxOf(tileset.tiles[0]), to_root * part.transform, {}};
    if (child.transform->isIdentity(0)) child.transform.reset();
    entry.box.extend(child.transform ? child.box.transformed(Eigen::Affine3d(*child.transform)) : child.box);
    // Without a model of its own it is never drawn in place of the tiles.
    entry.geometric_error = std::max(entry.geometric_error, 2 * child.box.diagonal().norm());
    entry.children.push_back(std::move(child));
  }
  return NewTileset(std::move(entry));
}

}  // namespace tilemend
