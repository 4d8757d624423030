#include "client/hole_crop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "absl/container/flat_hash_map.h"
#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/check/fill_pieces.h"

namespace tilemend {
namespace {

constexpr double kMargin = 1.0 / 3;  // of the fill's width
constexpr double kLeastMargin = 3, kMostMargin = 60;
constexpr double kCoarser = 1.3;      // from one grid to the next
constexpr double kMostOff = 0.5;      // of the hole's area: where folds were cut off its fill is smaller
constexpr double kCentreSlack = 0.2;  // metres: the centre of a hole in a wall may lie beside its fill

// On which sides of the box a point lies, a bit for each. Triangles whose corners share a bit lie outside it.
uint8_t SidesOf(const Point3& p, const Eigen::AlignedBox3d& box) {
  uint8_t sides = 0;
  for (int k = 0; k < 3; ++k) {
    sides |= static_cast<uint8_t>((p[k] < box.min()[k] ? 1 : 0) << 2 * k);
    sides |= static_cast<uint8_t>((p[k] > box.max()[k] ? 2 : 0) << 2 * k);
  }
  return sides;
}

using GridKey = std::array<int64_t, 3>;

GridKey KeyAt(const Point3& p, double step) {
  return {static_cast<int64_t>(std::floor(p.x() / step)), static_cast<int64_t>(std::floor(p.y() / step)),
          static_cast<int64_t>(std::floor(p.z() / step))};
}

// Faces by the numbers of their corners in a list of positions, so that a grid is asked once for each position.
class CropMesh {
 public:
  explicit CropMesh(const Eigen::AlignedBox3d& box) : box_(box) {}

  // Adds triangles of `mesh` that meet the box. `each` calls what it is given with each triangle to look at.
  void Add(const TriMesh& mesh, const auto& each) {
    std::vector<uint8_t> sides(mesh.points.size());
    for (size_t v = 0; v < sides.size(); ++v) sides[v] = SidesOf(mesh.points[v], box_);
    std::vector<int32_t> number(mesh.points.size(), -1);
    each([&](int32_t t, FaceState state) {
      const Triangle& corners = mesh.triangles[t];
      if ((sides[corners[0]] & sides[corners[1]] & sides[corners[2]]) != 0) return;
      faces_.push_back({t, state, corners});
      for (int32_t& v : faces_.back().corners) v = NumberOf(v, mesh, number);
    });
  }

  // Moves the vertices in each square of a grid to their mean, each counted once for each face. Faces that become flat
  // are dropped.
  void MoveToGrid(double step) {
    absl::flat_hash_map<GridKey, int32_t> squares;
    std::vector<int32_t> square_of(points_.size(), -1);
    std::vector<Point3> sums;
    std::vector<double> counts;
    GridKey last_key{INT64_MAX, 0, 0};  // neighbours are often in one square
    int32_t last_square = -1;
    for (const Face& face : faces_) {
      for (const int32_t v : face.corners) {
        if (square_of[v] < 0) {
          const GridKey key = KeyAt(points_[v], step);
          if (key != last_key) last_square = squares.try_emplace(key, std::ssize(sums)).first->second;
          last_key = key;
          square_of[v] = last_square;
          sums.resize(squares.size(), Point3(0, 0, 0));
          counts.resize(squares.size(), 0);
        }
        sums[square_of[v]] += points_[v];
        counts[square_of[v]] += 1;
      }
    }
    for (size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    points_ = std::move(sums);
    for (Face& face : faces_) {
      for (int32_t& v : face.corners) v = square_of[v];
    }
    std::erase_if(faces_, [](const Face& face) {
      const Triangle& v = face.corners;
      return v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    });
  }

  int64_t size() const { return std::ssize(faces_); }

  std::vector<HoleCrop::Face> Faces() const {
    std::vector<HoleCrop::Face> faces;
    faces.reserve(faces_.size());
    for (const Face& f : faces_) {
      faces.push_back({f.triangle, f.state, {points_[f.corners[0]], points_[f.corners[1]], points_[f.corners[2]]}});
    }
    return faces;
  }

 private:
  struct Face {
    int32_t triangle;
    FaceState state;
    Triangle corners;
  };

  int32_t NumberOf(int32_t v, const TriMesh& mesh, std::vector<int32_t>& number) {
    if (number[v] < 0) {
      number[v] = static_cast<int32_t>(points_.size());
      points_.push_back(mesh.points[v]);
    }
    return number[v];
  }

  const Eigen::AlignedBox3d box_;
  std::vector<Point3> points_;
  std::vector<Face> faces_;
};

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
  double least = kMostOff * area;
  for (const auto& [box, vector_area] : pieces) {
    const Point2 slack(kCentreSlack, kCentreSlack);
    const Point2 lo = box.min().head<2>() - slack, hi = box.max().head<2>() + slack;
    if ((centre.array() < lo.array()).any() || (centre.array() > hi.array()).any()) continue;
    // Not the area of the box: that of a bent fill is several times its own, so that a scrap would be nearer.
    const double off = std::min(std::abs(std::abs(vector_area.z()) - area), std::abs(vector_area.norm() - area));
    if (off <= least) {
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
  CropMesh mesh(box);
  mesh.Add(tile.after.faces.mesh, [&](const auto& use) {
    for (int32_t t = 0; t < std::ssize(tile.change.added); ++t) {
      use(t, tile.change.added[t] ? FaceState::kAdded : FaceState::kKept);
    }
  });
  if (!tile.change.missing.empty()) {
    mesh.Add(tile.before.faces.mesh, [&](const auto& use) {
      for (const int32_t t : tile.change.missing) use(t, FaceState::kCleared);
    });
  }
  HoleCrop crop;
  crop.faces_there = mesh.size();
  double step = box.sizes().head<2>().norm() / std::sqrt(static_cast<double>(kMostCropFaces));
  for (; mesh.size() > kMostCropFaces; step *= kCoarser) mesh.MoveToGrid(step);
  crop.faces = mesh.Faces();
  return crop;
}

}  // namespace tilemend
