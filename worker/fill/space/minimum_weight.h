// Minimum-weight triangulation of a closed loop in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_
#define TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_

#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Triangulates the loop without new vertices, of all ways the one whose worst dihedral angle (among the triangles and
// with the surroundings) is least, and of those the one of least area (Liepa 2003, 3; dynamic programming after
// Klincsek 1980).
//   loop      positions in order, with the hole on the left seen from outside; at least 3
//   outside   unit normal of the original triangle at edge i (loop[i], loop[i + 1]); zero if unknown
//   allowed   whether a chord between loop[i] and loop[j] may be made (an edge that the surface has already may not)
//   fits      whether triangle loop[i], loop[j], loop[k], i < j < k, may be made; asked last, only where it matters
// Returns triangles over loop indices, oriented like the loop; empty if there is no allowed triangulation with every
// triangle's area above zero. O(n^3) time, O(n^2) memory.
std::vector<Triangle> TriangulateLoop(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                      const std::function<bool(int32_t, int32_t)>& allowed,
                                      const std::function<bool(int32_t, int32_t, int32_t)>& fits = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_MINIMUM_WEIGHT_H_
