// Edges inside a patch that the surface around it has already.
#ifndef TILEMEND_WORKER_FILL_SPACE_OVERFULL_EDGES_H_
#define TILEMEND_WORKER_FILL_SPACE_OVERFULL_EDGES_H_

#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Divides the patch's inner edges between two vertices of the rim beside which the surface has triangles: with the
// patch they would have three or more. Each gets a new point in the middle, on the lattice, so that one triangle on
// either side becomes two. Such edges are where surface hangs together above or below the hole, as a wall between two
// vertices of its rim. O(n), and O(n) for each edge that is divided.
void DivideOverfullEdges(const LocalHole& hole, LocalPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_OVERFULL_EDGES_H_
