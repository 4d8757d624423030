// Finds things by where they lie in the plane.
#ifndef TILEMEND_COMMON_MESH_BIN_GRID_H_
#define TILEMEND_COMMON_MESH_BIN_GRID_H_

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {

// A uniform grid of square bins over a box; each bin lists the things whose boxes meet it, by their numbers, rising.
// What lies outside the grid counts to the nearest bins. Building is linear in the entries (a thing has one in every
// bin that it meets); memory is 4 bytes an entry and a bin. Deterministic. It is exact but for coordinates within a
// rounding error of a line. Their bin may be either, so a search must not depend on that.
class BinGrid {
 public:
  // Bins of `step` metres over `extent` (not empty) for things 0 to count - 1. The box of thing i is box_of(i), an
  // Eigen::AlignedBox2d. Preconditions: step > 0, and the bins are fewer than 2^31.
  template <typename BoxOf>
  BinGrid(const Eigen::AlignedBox2d& extent, double step, int32_t count, const BoxOf& box_of);

  double step() const { return step_; }
  int64_t columns() const { return columns_; }
  int64_t rows() const { return rows_; }
  const Point2& lo() const { return lo_; }

  // The bin that p lies in, row by row from the south-west.
  int64_t BinOf(const Point2& p) const {
    return BinAt(p.y() - lo_.y(), rows_) * columns_ + BinAt(p.x() - lo_.x(), columns_);
  }

  // Calls visit(bin, things) for every bin that `box` meets, rising. A thing is passed in all of its bins. To take it
  // once, take it in BinOf the lower corner of what its box has in common with `box`.
  template <typename Visit>
  void ForBins(const Eigen::AlignedBox2d& box, const Visit& visit) const;

  // The things in the bins that `box` meets (more than those whose boxes meet it), each once, rising.
  std::vector<int32_t> In(const Eigen::AlignedBox2d& box) const;

 private:
  int64_t BinAt(double offset, int64_t count) const {
    return static_cast<int64_t>(std::clamp(offset / step_, 0.0, static_cast<double>(count - 1)));
  }
  template <typename Visit>
  void ForBinNumbers(const Eigen::AlignedBox2d& box, const Visit& visit) const;

  Point2 lo_;
  double step_;
  int64_t columns_, rows_;
  VertexLists things_;  // of each bin
};

template <typename BoxOf>
BinGrid::BinGrid(const Eigen::AlignedBox2d& extent, double step, int32_t count, const BoxOf& box_of)
    : lo_(extent.min()),
      step_(step),
      columns_(static_cast<int64_t>(extent.sizes().x() / step) + 1),
      rows_(static_cast<int64_t>(extent.sizes().y() / step) + 1),
      things_(static_cast<size_t>(columns_ * rows_), [&](const auto& use) {
        for (int32_t i = 0; i < count; ++i) {
          ForBinNumbers(box_of(i), [&](int64_t bin) { use(static_cast<int32_t>(bin), i); });
        }
      }) {}

template <typename Visit>
void BinGrid::ForBinNumbers(const Eigen::AlignedBox2d& box, const Visit& visit) const {
  const Point2 lo = box.min() - lo_, hi = box.max() - lo_;
  const int64_t first = BinAt(lo.x(), columns_), last = BinAt(hi.x(), columns_), top = BinAt(hi.y(), rows_);
  for (int64_t row = BinAt(lo.y(), rows_); row <= top; ++row) {
    for (int64_t column = first; column <= last; ++column) visit(row * columns_ + column);
  }
}

template <typename Visit>
void BinGrid::ForBins(const Eigen::AlignedBox2d& box, const Visit& visit) const {
  ForBinNumbers(box, [&](int64_t bin) { visit(bin, things_.Of(static_cast<int32_t>(bin))); });
}

inline std::vector<int32_t> BinGrid::In(const Eigen::AlignedBox2d& box) const {
  std::vector<int32_t> found;
  ForBins(box,
          [&](int64_t, std::span<const int32_t> things) { found.insert(found.end(), things.begin(), things.end()); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_BIN_GRID_H_
