// What became of the faces of a tile: which of the original ones are gone, and which are new.
#ifndef TILEMEND_WORKER_CHECK_TILE_CHANGE_H_
#define TILEMEND_WORKER_CHECK_TILE_CHANGE_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A mesh, and what its triangles look like.
struct LookedMesh {
  TriMesh mesh;
  // Of each triangle: a digest of all that it has beside the positions of its corners (material, texture coordinates,
  // colours and further properties). Empty: the looks are not known.
  std::vector<uint64_t> looks;
};

struct TileChange {
  std::vector<int32_t> missing;  // triangles of `before` that are not in `after`, rising
  std::vector<bool> added;       // of each triangle of `after`: it was not in `before`
  int64_t added_count = 0;
};

// Two triangles are the same if the positions of their corners are the same to the bit, in the same order, and their
// looks are. A triangle that is there twice must be there twice again. Pure. O(n) where the triangles that stay keep
// their order, else O(n log n). Precondition: the looks of both are known, or those of neither. Without looks only the
// positions are compared.
TileChange CompareTiles(const LookedMesh& before, const LookedMesh& after);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_TILE_CHANGE_H_
