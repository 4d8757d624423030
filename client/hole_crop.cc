#include "client/hole_crop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "absl/container/flat_hash_map.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/check/fill_pieces.h"

namespace tilemend {
namespace {

constexpr double kMargin = 1.0 / 3;  // of the fill's width
constexpr double kLeastMargin = 3, kMostMargin = 60;
constexpr double kCoarser = 1.3;      // from one grid to the next
constexpr double kCentreSlack = 0.2;  // metres: the centre of a hole in a wall may lie beside its fill

SpaceTriangle CornersOf(const TriMesh& mesh, int32_t t) {
  const Triangle& corners = mesh.triangles[t];
  return {mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]};
}

Eigen::AlignedBox3d BoxOfCorners(const SpaceTriangle& t) {
  Eigen::AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

using GridKey = std::array<int64_t, 3>;

GridKey KeyAt(const Point3& p, double step) {
  return {static_cast<int64_t>(std::floor(p.x() / step)), static_cast<int64_t>(std::floor(p.y() / step)),
          static_cast<int64_t>(std::floor(p.z() / step))};
}

// The faces with the vertices of each square of a grid moved to their mean; those that become flat are gone.
std::vector<HoleCrop::Face> OnGrid(const std::vector<HoleCrop::Face>& faces, double step) {
  absl::flat_hash_map<GridKey, std::pair<Point3, double>> sums;
  for (const HoleCrop::Face& face : faces) {
    for (const Point3& p : face.corners) {
      auto& [sum, count] = sums.try_emplace(KeyAt(p, step), Point3(0, 0, 0), 0.0).first->second;
      sum += p;
      count += 1;
    }
  }
  std::vector<HoleCrop::Face> kept;
  for (HoleCrop::Face face : faces) {
    std::array<GridKey, 3> keys;
    for (size_t k = 0; k < 3; ++k) {
      keys[k] = KeyAt(face.corners[k], step);
      const auto& [sum, count] = sums.at(keys[k]);
      face.corners[k] = sum / count;
    }
    if (keys[0] != keys[1] && keys[1] != keys[2] && keys[2] != keys[0]) kept.push_back(face);
  }
  return kept;
}

}  // namespace

std::vector<AddedPiece> AddedPieces(const TriMesh& mesh, const std::vector<bool>& added) {
  PositionIndex index;
  std::vector<Triangle> triangles;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!added[t]) continue;
    Triangle& welded = triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) welded[k] = index.Insert(mesh.points[mesh.triangles[t][k]]);
  }
  std::vector<AddedPiece> pieces;
  for (const std::vector<Triangle>& of_piece : PiecesByEdges(triangles)) {
    AddedPiece& piece = pieces.emplace_back();
    for (const Triangle& t : of_piece) {
      for (const int32_t v : t) piece.box.extend(index.positions()[v]);
      piece.vector_area += TwiceVectorArea(index.positions(), t) / 2;
    }
  }
  return pieces;
}

Eigen::AlignedBox3d PieceAt(const std::vector<AddedPiece>& pieces, const Point2& centre, double area) {
  Eigen::AlignedBox3d best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [box, vector_area] : pieces) {
    const Point2 slack(kCentreSlack, kCentreSlack);
    const Point2 lo = box.min().head<2>() - slack, hi = box.max().head<2>() + slack;
    if ((centre.array() < lo.array()).any() || (centre.array() > hi.array()).any()) continue;
    // Not the area of the box: that of a bent fill is several times its own, so that a scrap would be nearer.
    const double off = std::min(std::abs(std::abs(vector_area.z()) - area), std::abs(vector_area.norm() - area));
    if (off < least) {
      least = off;
      best = box;
    }
  }
  return best;
}

HoleCrop CropAround(const TilePair& tile, const Eigen::AlignedBox3d& fill) {
  const double margin = std::clamp(kMargin * fill.sizes().maxCoeff(), kLeastMargin, kMostMargin);
  Eigen::AlignedBox3d box = fill;
  box.extend(Point3(fill.min().array() - margin));
  box.extend(Point3(fill.max().array() + margin));
  HoleCrop crop;
  const auto add = [&](const TriMesh& mesh, int32_t t, FaceState state) {
    const SpaceTriangle corners = CornersOf(mesh, t);
    if (box.intersects(BoxOfCorners(corners))) crop.faces.push_back({t, state, corners});
  };
  for (int32_t t = 0; t < std::ssize(tile.change.added); ++t) {
    add(tile.after.faces.mesh, t, tile.change.added[t] ? FaceState::kAdded : FaceState::kKept);
  }
  for (const int32_t t : tile.change.missing) add(tile.before.faces.mesh, t, FaceState::kCleared);
  crop.faces_there = std::ssize(crop.faces);
  double step = box.sizes().head<2>().norm() / std::sqrt(static_cast<double>(kMostCropFaces));
  for (; std::ssize(crop.faces) > kMostCropFaces; step *= kCoarser) crop.faces = OnGrid(crop.faces, step);
  return crop;
}

}  // namespace tilemend
