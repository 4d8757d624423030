// Cuts a long loop in space down to a short one.
#ifndef TILEMEND_WORKER_FILL_SPACE_CLIP_EARS_H_
#define TILEMEND_WORKER_FILL_SPACE_CLIP_EARS_H_

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/space/crossing_index.h"

namespace tilemend {

struct ClippedLoop {
  std::vector<Triangle> triangles;       // over places of the loop, oriented like it
  std::vector<int32_t> rest;             // the places that are left, in order
  std::vector<Eigen::Vector3d> outside;  // beside the edge from each of these to the next
};

// Clips triangles of three places in a row, the shortest new edge first, until at most `most` places are left or none
// can be clipped. So the loop gets coarser evenly: each round halves it. What turns the wrong way beside its neighbours
// is left to later rounds, and what crosses `taken` is not clipped; `taken` gets the triangles.
//   loop, outside, allowed  as for TriangulateLoop (minimum_weight.h)
// O(n log^2 n) where few triangles lie close together; deterministic.
ClippedLoop ClipEars(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                     const std::function<bool(int32_t, int32_t)>& allowed, int32_t most, CrossingIndex& taken);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_CLIP_EARS_H_
