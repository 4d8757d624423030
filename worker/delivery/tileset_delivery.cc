#include "worker/delivery/tileset_delivery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/codec/gltf/new_glb.h"
#include "common/codec/tiles3d/new_tileset.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

std::vector<GltfPatch> ModelOf(const DeliveryTile& tile, const DeliveryPiece& piece, const Point3& origin) {
  std::vector<GltfPatch> model;
  for (const DeliverySurface& surface : piece.surfaces) {
    if (surface.mesh.triangles.empty()) continue;
    GltfPatch patch{surface.mesh.points, surface.uv, surface.mesh.triangles, "", "", surface.colour};
    if (surface.image >= 0) patch.image = tile.images[static_cast<size_t>(surface.image)];
    for (Point3& point : patch.points) point -= origin;
    model.push_back(std::move(patch));
  }
  return model;
}

class TilesetMaker {
 public:
  TilesetMaker(const DeliveryTile& tile, const std::string& stem, const Point3& origin)
      : tile_(tile), stem_(stem), origin_(origin) {}

  absl::StatusOr<std::vector<DeliveryFile>> Make() {
    files_.push_back({stem_ + ".json", ""});
    nodes_.resize(tile_.pieces.size());
    for (size_t p = 0; p < tile_.pieces.size(); ++p) TILEMEND_RETURN_IF_ERROR(AddModel(p));
    NewTile root;
    for (size_t p = tile_.pieces.size(); p-- > 0;) {  // children before parents
      NewTile node = std::move(nodes_[p]);
      std::reverse(node.children.begin(), node.children.end());
      if (node.box.isEmpty()) continue;
      const int32_t parent = tile_.pieces[p].parent;
      NewTile& above = parent < 0 ? root : nodes_[static_cast<size_t>(parent)];
      above.box.extend(node.box);
      above.children.push_back(std::move(node));
    }
    std::reverse(root.children.begin(), root.children.end());
    if (root.children.size() == 1) root = std::move(root.children[0]);
    if (!root.children.empty() && root.file.empty()) root.geometric_error = root.box.diagonal().norm();
    if (!origin_.isZero(0)) {
      root.transform = Eigen::Matrix4d::Identity();
      root.transform->topRightCorner<3, 1>() = origin_;
    }
    files_[0].bytes = NewTileset(std::move(root));
    return std::move(files_);
  }

 private:
  absl::Status AddModel(size_t p) {
    const DeliveryPiece& piece = tile_.pieces[p];
    const std::vector<GltfPatch> model = ModelOf(tile_, piece, origin_);
    NewTile& node = nodes_[p];
    node.geometric_error = piece.geometric_error;
    if (model.empty()) return absl::OkStatus();
    for (const GltfPatch& patch : model) {
      // As the file has them.
      for (const Point3& point : patch.points) node.box.extend(Point3(point.cast<float>().cast<double>()));
    }
    node.file = absl::StrCat(stem_, "_", p, ".glb");
    TILEMEND_ASSIGN_OR_RETURN(std::string bytes, NewGlb(model, node.file));
    files_.push_back({node.file, std::move(bytes)});
    return absl::OkStatus();
  }

  const DeliveryTile& tile_;
  const std::string& stem_;
  const Point3 origin_;
  std::vector<DeliveryFile> files_;
  std::vector<NewTile> nodes_;  // of the pieces
};

}  // namespace

absl::StatusOr<std::vector<DeliveryFile>> TilesetFilesOf(const DeliveryTile& tile, const std::string& stem,
                                                         const Point3& origin) {
  return TilesetMaker(tile, stem, origin).Make();
}

}  // namespace tilemend
