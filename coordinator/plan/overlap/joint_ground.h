// What is ground at the boundary vertices of tiles that overlap.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_GROUND_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_GROUND_H_

#include <map>

#include "common/records/rim_ground.h"
#include "coordinator/plan/overlap/joint_tiles.h"

namespace tilemend {

// The values of each vertex of JointTiles::records. The tiles' own boundary vertices have those in `rim_ground`. A new
// vertex takes them from the ends of the edge that passes it at its height. It gets the ground linearly, the flag of
// the nearer end. One that no edge passes, on a grid line, has those of the nearest own vertex. Tiles that `rim_ground`
// does not have stand on the ground. Cost O(n) in the vertices, and for each such one.
std::map<CellId, RimGround> JointGround(const JointTiles& joint, const std::map<CellId, RimGround>& rim_ground);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_GROUND_H_
