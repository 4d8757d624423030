// What a loop inside one cell bounds: a hole, or a piece of surface.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_CLOSED_LOOPS_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_CLOSED_LOOPS_H_

#include <vector>

#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/hole/hole_site.h"
#include "coordinator/plan/hole/piece_boundaries.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct ClosedLoop {
  std::vector<RimSegment> segments;  // a hole on the left, or all around
  Eigen::Vector3d vector_area{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 0};  // mean of the surface along the loop
  bool faces_up = false;            // the surface does
  bool outer_rim = false;           // the outline of a piece, and no hole in it
};

// Reads a loop of rim points inside a cell. It is an outline if it runs the wrong way round for the normals along it.
// If the surface along it is a height field, it is an outline if it does so seen from above. Where the two contradict
// each other along a few edges, the piece of surface tells: its outline has all of its boundary within. So does an
// outline of few edges. Else it is a hole whose patch faces the other way than the surface around it, as where a crown
// hangs over. Cost O(n log n).
ClosedLoop ReadLoop(const HoleSite& site, std::vector<RimSegment> segments, PieceBoundaries& pieces);

// Whether a piece of surface lies in a hole. It must be smaller than the hole, lie within its boundary seen along its
// normal, and face the same way. It must also lie between the boundary and where the surface that leans in from there
// would be, give or take an edge's length.
bool LiesIn(const HoleSite& site, const ClosedLoop& piece, const ClosedLoop& hole);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_CLOSED_LOOPS_H_
