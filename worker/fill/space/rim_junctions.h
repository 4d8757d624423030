// Vertices of a hole's boundary that lie on an edge of it.
#ifndef TILEMEND_WORKER_FILL_SPACE_RIM_JUNCTIONS_H_
#define TILEMEND_WORKER_FILL_SPACE_RIM_JUNCTIONS_H_

#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// Whether a vertex of the boundary lies on an edge that does not end there (a T-junction), to a 4096th of the edge:
// what was one line before coordinates were rounded, a turned mesh's or one of floats. O(n log n).
bool HasJunction(const LocalHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_RIM_JUNCTIONS_H_
