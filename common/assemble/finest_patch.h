// Looks into the patch of a tile's finest level, to take vertices of it for coarser levels.
#ifndef TILEMEND_COMMON_ASSEMBLE_FINEST_PATCH_H_
#define TILEMEND_COMMON_ASSEMBLE_FINEST_PATCH_H_

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "common/codec/mesh_file.h"
#include "common/mesh/bin_grid.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// What surrounds the new vertices of a patch. Both arguments must outlive it. O(n).
class FinestPatch {
 public:
  FinestPatch(const TriMesh& finest, const FilePatch& patch);

  // A vertex, by the numbers of AppendPatch.
  const Point3& At(int32_t v) const;
  // The median length of edges along the rim, metres; of all edges where no edge has both ends on the rim.
  double rim_edge() const { return rim_edge_; }
  // The shortest edge at a new vertex, metres.
  double EdgeAt(size_t new_point) const { return lengths_[new_point]; }
  // Whether the new vertices around a new vertex have its height to the bit, as in water.
  bool IsLevelAt(size_t new_point) const { return is_level_[new_point]; }
  // The run of materials that a new vertex is in.
  int32_t RunAt(size_t new_point) const { return runs_[new_point]; }

 private:
  bool IsNew(int32_t v) const { return v >= static_cast<int32_t>(finest_.points.size()); }
  size_t NewPoint(int32_t v) const { return static_cast<size_t>(v) - finest_.points.size(); }
  void LookAtEdges();
  void LookAtRuns();

  const TriMesh& finest_;
  const FilePatch& patch_;
  std::vector<double> lengths_;
  std::vector<bool> is_level_;
  std::vector<int32_t> runs_;
  double rim_edge_ = 0;
};

// The middle one of values; 0 for none.
double MedianOf(std::vector<double> values);

// Finds the nearest of some positions, seen from above. They must outlive it.
class NearestPosition {
 public:
  explicit NearestPosition(const std::vector<Point3>& positions);
  // The number of the nearest, of several the lowest; -1 if there is none.
  int32_t Of(const Point2& p) const;

 private:
  const std::vector<Point3>& positions_;
  Eigen::AlignedBox2d extent_;
  std::optional<BinGrid> grid_;
};

// Thins vertices to longer edges: in each square of a lattice, whose step fits the edges there, the first one stays.
class VertexThinning {
 public:
  // Edges are to be `factor` times as long as they are, and no shorter than `least` metres.
  VertexThinning(double factor, double least) : factor_(factor), least_(least) {}

  // Whether a vertex with edges of `edge` metres is the first in its square.
  bool Take(const Point2& p, double edge);

 private:
  const double factor_, least_;
  std::set<std::tuple<int, int64_t, int64_t>> taken_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_FINEST_PATCH_H_
