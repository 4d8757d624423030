// Closes cracks by merging the vertices on both sides, as far as a tolerance reaches.
#ifndef TILEMEND_WORKER_WELD_WELD_RIMS_H_
#define TILEMEND_WORKER_WELD_WELD_RIMS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/mesh_view.h"
#include "common/records/weld.h"

namespace tilemend {

struct Weld {
  WeldRecord record;
  // By vertices of the mesh; there are no others. First its triangles as they are now, in order, then those that came
  // of splitting edges. Unchanged ones are as they were.
  std::vector<Triangle> triangles;
  std::vector<int32_t> cut_from;  // of each that came of splitting: the triangle of the mesh that it was a part of
};

// Merges boundary vertices that are no further apart than `tolerance`, the nearest first. Then splits boundary edges
// beside which a boundary vertex is left (T-junctions), so that the two sides share it. No position changes: faces name
// the lower of two vertices. No vertex ends up further from its position than `tolerance`, nor than the shortest
// boundary edge at it.
//
// Merges and splits are refused, with a reason, if they would take the area of a face or turn it over. The same if they
// give an edge more than two faces, or join the two sides of a wall.
//   face_of    the face of the file that each triangle is a part of, rising (common/codec/face_edits.h); empty: each is
//              one
//   may_split  whether edges may be split: the new half of a face has no texture coordinates
// Zhang 2022, 4.3, merges what is nearest as well, but moves both. O(n log n); deterministic. Precondition: tolerance
// > 0.
Weld WeldRims(const MeshView& mesh, std::span<const int32_t> face_of, double tolerance, bool may_split);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_WELD_WELD_RIMS_H_
