// The original triangles at the rim vertices of a cell's holes.
#ifndef TILEMEND_WORKER_FILL_CELL_BAND_H_
#define TILEMEND_WORKER_FILL_CELL_BAND_H_

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "common/grid/cell_holes.h"

namespace tilemend {

// Looks up band triangles by rim vertex. The CellHoles must outlive it.
class CellBand {
 public:
  explicit CellBand(const CellHoles& cell) : cell_(cell), at_(cell.vertices.size()) {
    for (size_t t = 0; t < cell.band.triangles.size(); ++t) {
      for (const int32_t v : cell.band.triangles[t]) {
        if (v < static_cast<int32_t>(at_.size())) at_[v].push_back(static_cast<int32_t>(t));
      }
    }
  }

  const std::vector<int32_t>& At(int32_t vertex) const { return at_[vertex]; }

  Eigen::Vector3d Normal(int32_t triangle) const {
    const Triangle& t = cell_.band.triangles[triangle];
    const auto& p = cell_.band.points;
    return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
  }

  bool HasEdge(int32_t a, int32_t b) const {
    return std::any_of(at_[a].begin(), at_[a].end(), [&](int32_t t) {
      const Triangle& tri = cell_.band.triangles[t];
      return std::find(tri.begin(), tri.end(), b) != tri.end();
    });
  }

  int CountEdge(int32_t a, int32_t b) const {
    return static_cast<int>(std::count_if(at_[a].begin(), at_[a].end(), [&](int32_t t) {
      const Triangle& tri = cell_.band.triangles[t];
      return std::find(tri.begin(), tri.end(), b) != tri.end();
    }));
  }

  bool HasTriangle(const Triangle& t) const {
    return std::any_of(at_[t[0]].begin(), at_[t[0]].end(), [&](int32_t other) {
      return std::is_permutation(t.begin(), t.end(), cell_.band.triangles[other].begin());
    });
  }

 private:
  const CellHoles& cell_;
  std::vector<std::vector<int32_t>> at_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CELL_BAND_H_
