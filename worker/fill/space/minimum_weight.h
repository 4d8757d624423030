// Minimum-weight triangulation of a closed loop in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_
#define TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Triangulates the loop without new vertices. Of all ways it takes the one whose worst dihedral angle (among the
// triangles and with the surroundings) is least. Of those it takes the one of least area. Source: Liepa 2003, 3;
// dynamic programming after Klincsek 1980.
//   loop      positions in order, with the hole on the left seen from outside; at least 3
//   outside   unit normal of the original triangle at edge i (loop[i], loop[i + 1]); zero if unknown
//   allowed   whether a chord between loop[i] and loop[j] may be made (an edge that the surface has already may not)
//   fits      whether triangle loop[i], loop[j], loop[k], i < j < k, may be made; asked last, only where it matters
// Returns triangles over loop indices, oriented like the loop; empty if there is no allowed triangulation with every
// triangle's area above zero. O(n^3) time, O(n^2) memory.
std::vector<Triangle> TriangulateLoop(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                      const std::function<bool(int32_t, int32_t)>& allowed,
                                      const std::function<bool(int32_t, int32_t, int32_t)>& fits = {});

// Whether triangles that do not fit are taken where none fits.
enum class Misfits {
  kNone,
  // In a span where none fits: the one with which that span has the fewest. One that fits is taken before, whatever the
  // spans beside it hold, so there may be more in all than are needed. With the fewest in all, more triangles of 16
  // street cuts crossed each other: 140, not 126.
  kFew,
};

// The same, to be done again with fewer triangles.
class LoopTriangulation {
 public:
  // All must outlive it.
  LoopTriangulation(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                    const std::function<bool(int32_t, int32_t)>& allowed,
                    const std::function<bool(int32_t, int32_t, int32_t)>& fits, Misfits misfits = Misfits::kNone);

  // What TriangulateLoop gives. The first time O(n^3); then only spans are looked at whose triangulation depends on
  // what was forbidden.
  std::vector<Triangle> Run();
  // Tells that a triangle, which has an answer, fits no longer.
  void Forbid(const Triangle& t) { is_stale_[At(t[0], t[2])] = 1; }

 private:
  // Worst dihedral angle (as 1 - cosine, 0 flat, 2 folded back), then area.
  struct Weight {
    double angle = 0;
    double area = 0;
    bool operator<(const Weight& other) const { return angle != other.angle ? angle < other.angle : area < other.area; }
  };
  // A triangulation of a span, by the vertex of the triangle that closes it; -1: none.
  struct Choice {
    Weight weight{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    int32_t vertex = -1;
    bool operator<(const Choice& other) const {
      return weight < other.weight || (!(other.weight < weight) && vertex < other.vertex);
    }
  };

  size_t At(int32_t i, int32_t k) const {
    return static_cast<size_t>(i) * static_cast<size_t>(n_) + static_cast<size_t>(k);
  }
  Eigen::Vector3d AreaVector(int32_t i, int32_t j, int32_t k) const {
    return (loop_[j] - loop_[i]).cross(loop_[k] - loop_[i]) / 2;
  }
  void Solve(int32_t i, int32_t k);
  Choice Choose(int32_t i, int32_t k) const;
  void Try(int32_t i, int32_t j, int32_t k, Choice& best) const;

  std::span<const Point3> loop_;
  std::span<const Eigen::Vector3d> outside_;
  const std::function<bool(int32_t, int32_t)>& allowed_;
  const std::function<bool(int32_t, int32_t, int32_t)>& fits_;
  const Misfits misfits_;
  int32_t n_;
  // By span: its best triangulation, the vertex of the triangle that closes it, and the normal there. For one edge that
  // is the normal of the surface outside (x, y, z, 1; 0 if unknown). What is looked up for all spans to one end is kept
  // with the end first as well.
  std::vector<Weight> best_, best_by_end_;
  std::vector<int32_t> choice_;
  std::vector<Eigen::Vector4d> normal_, normal_by_end_;
  std::vector<uint8_t> is_stale_;
  std::vector<int32_t> changed_from_, changed_to_;  // in this run: the shortest that begins at, and that ends at
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_
