#include "worker/delivery/osgb_delivery.h"

#include <Eigen/Geometry>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/osgb/osgb_new.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

class OsgbMaker {
 public:
  OsgbMaker(const DeliveryTile& tile, const std::string& stem)
      : tile_(tile), stem_(stem), levels_(tile.pieces.size()), boxes_(tile.pieces.size()), finer_(tile.pieces.size()) {
    for (size_t p = 0; p < tile.pieces.size(); ++p) {
      const int32_t parent = tile.pieces[p].parent;
      (parent < 0 ? roots_ : finer_[static_cast<size_t>(parent)]).push_back(p);
      if (parent >= 0) levels_[p] = levels_[static_cast<size_t>(parent)] + 1;
    }
    for (size_t p = tile.pieces.size(); p-- > 0;) {  // children before parents
      for (const DeliverySurface& surface : tile.pieces[p].surfaces) {
        for (const Point3& point : surface.mesh.points) boxes_[p].extend(point);
      }
      for (const size_t child : finer_[p]) boxes_[p].extend(boxes_[child]);
    }
  }

  absl::StatusOr<std::vector<DeliveryFile>> Make() {
    TILEMEND_RETURN_IF_ERROR(AddFile(stem_ + ".osgb", roots_));
    for (size_t p = 0; p < finer_.size(); ++p) {
      if (!finer_[p].empty()) TILEMEND_RETURN_IF_ERROR(AddFile(FinerName(p), finer_[p]));
    }
    return std::move(files_);
  }

 private:
  std::string FinerName(size_t p) const { return absl::StrCat(stem_, "_L", levels_[p] + 1, "_", p, ".osgb"); }

  absl::Status AddFile(std::string name, const std::vector<size_t>& pieces) {
    std::vector<OsgbNode> nodes;
    for (const size_t p : pieces) nodes.push_back(NodeOf(p));
    TILEMEND_ASSIGN_OR_RETURN(std::string bytes, NewOsgb(nodes, name));
    files_.push_back({std::move(name), std::move(bytes)});
    return absl::OkStatus();
  }

  OsgbNode NodeOf(size_t p) const {
    constexpr double kPixels = 16;  // the error on the screen at which viewers of 3D Tiles refine, by default
    OsgbNode node;
    for (const DeliverySurface& surface : tile_.pieces[p].surfaces) {
      if (!surface.mesh.triangles.empty()) node.geometries.push_back(GeometryOf(surface));
    }
    if (finer_[p].empty()) return node;
    node.finer = FinerName(p);
    node.center = boxes_[p].center();
    node.radius = boxes_[p].diagonal().norm() / 2;
    const double error = tile_.pieces[p].geometric_error;
    if (error > 0) node.range = kPixels * 2 * node.radius / error;
    return node;
  }

  OsgbPatch GeometryOf(const DeliverySurface& surface) const {
    OsgbPatch patch;
    patch.points = surface.mesh.points;
    patch.uv = surface.uv;
    patch.triangles = surface.mesh.triangles;
    patch.colour = surface.colour;
    if (surface.image >= 0) {
      patch.image = tile_.images[static_cast<size_t>(surface.image)];
      patch.image_name = absl::StrCat(stem_, "_", surface.image, ".", std::string(ImageEnding(patch.image)));
    }
    return patch;
  }

  const DeliveryTile& tile_;
  const std::string& stem_;
  std::vector<int> levels_;                 // of the pieces
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the pieces and all that takes their place
  std::vector<std::vector<size_t>> finer_;  // pieces that take the place of each
  std::vector<size_t> roots_;
  std::vector<DeliveryFile> files_;
};

}  // namespace

absl::StatusOr<std::vector<DeliveryFile>> OsgbFilesOf(const DeliveryTile& tile, const std::string& stem) {
  return OsgbMaker(tile, stem).Make();
}

}  // namespace tilemend
