// The triangles at the rim vertices of a cell's holes: the original ones, and those of patches made before.
#ifndef TILEMEND_WORKER_FILL_HOLE_CELL_BAND_H_
#define TILEMEND_WORKER_FILL_HOLE_CELL_BAND_H_

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/triangle_shape.h"
#include "common/records/cell_holes.h"

namespace tilemend {

// Looks up band triangles by their vertices, and edges between rim vertices. The CellHoles must outlive it.
class CellBand {
 public:
  explicit CellBand(const CellHoles& cell) : cell_(cell), at_(std::max(cell.vertices.size(), cell.band.points.size())) {
    for (size_t t = 0; t < cell.band.triangles.size(); ++t) {
      for (const int32_t v : cell.band.triangles[t]) at_[v].push_back(static_cast<int32_t>(t));
    }
    passes_.resize(cell.vertices.size());
    for (const CellHole& hole : cell.holes) {
      for (const RimSegment& s : hole.segments) ++passes_[s.from];
    }
  }

  // How often boundaries of the cell's holes come by a rim vertex.
  int Passes(int32_t vertex) const { return passes_[vertex]; }

  // Takes note of the edges inside a patch that run between rim vertices.
  void Add(const CellHole& hole, const HolePatch& patch) {
    std::vector<std::pair<int32_t, int32_t>> boundary;
    for (const RimSegment& s : hole.segments) boundary.emplace_back(std::minmax(s.from, s.to));
    std::sort(boundary.begin(), boundary.end());
    for (const Triangle& t : patch.triangles) {
      for (int k = 0; k < 3; ++k) {
        const std::pair<int32_t, int32_t> edge = std::minmax(t[k], t[(k + 1) % 3]);
        if (edge.first < 0 || std::binary_search(boundary.begin(), boundary.end(), edge)) continue;
        patched_.insert(edge);
      }
    }
  }

  // In CellHoles::band.points.
  const std::vector<int32_t>& At(int32_t vertex) const { return at_[vertex]; }

  Eigen::Vector3d Normal(int32_t triangle) const {
    return TwiceVectorArea(cell_.band.points, cell_.band.triangles[triangle]);
  }

  // Unit normal of the original triangle at the edge between rim vertices a and b; zero if there is none.
  Eigen::Vector3d UnitNormalBeside(int32_t a, int32_t b) const {
    for (const int32_t t : at_[a]) {
      const Triangle& corners = cell_.band.triangles[t];
      if (std::find(corners.begin(), corners.end(), b) == corners.end()) continue;
      const Eigen::Vector3d normal = Normal(t);
      return normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::Zero();
    }
    return Eigen::Vector3d::Zero();
  }

  // The triangles at an edge between two rim vertices.
  int CountEdge(int32_t a, int32_t b) const {
    const auto originals = std::count_if(at_[a].begin(), at_[a].end(), [&](int32_t t) {
      const Triangle& tri = cell_.band.triangles[t];
      return std::find(tri.begin(), tri.end(), b) != tri.end();
    });
    return static_cast<int>(originals) + (patched_.contains(std::minmax(a, b)) ? 2 : 0);
  }

  bool HasTriangle(const Triangle& t) const {
    return std::any_of(at_[t[0]].begin(), at_[t[0]].end(), [&](int32_t other) {
      return std::is_permutation(t.begin(), t.end(), cell_.band.triangles[other].begin());
    });
  }

 private:
  const CellHoles& cell_;
  std::vector<std::vector<int32_t>> at_;
  std::vector<int> passes_;
  std::set<std::pair<int32_t, int32_t>> patched_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_CELL_BAND_H_
