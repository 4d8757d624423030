// Where sharp edges of the surface end at the rim of a hole.
//
// A crease is where two smooth parts of the surface meet at an angle: a roof's edge, the foot of a wall.
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_ENDS_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_ENDS_H_

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "worker/fill/hole/rim_loops.h"

namespace tilemend {

// A crease that ends at the rim.
struct CreaseEnd {
  int32_t loop = 0;
  int32_t place = 0;        // in the loop: where the rim crosses the crease
  int32_t order = 0;        // among the ends at one place, along the rim
  Eigen::Vector3d before;   // unit normal of the surface beside the rim before the place
  Eigen::Vector3d after;    // and after it
  Eigen::Vector3d tangent;  // unit, along the crease into the hole
};

// What counts as a crease.
enum class Bends {
  kOverSeveralEdges,  // the surface may turn over several edges of the rim: those of buildings are often worn
  // Half of the turn at least is between two neighbouring edges. In a mesh of any shape what turns step by step is as
  // likely the side of a small hole in something round.
  kAtOneEdge,
};

// Where creases end at the rim of a hole, in order of loop and place. A crease is a place where the normals beside the
// rim change by at least 30 degrees. Before it they are alike, and so they are after it. So rough ground and round
// walls have none. O(rim * bends).
std::vector<CreaseEnd> FindCreaseEnds(std::span<const RimLoop> loops, Bends bends);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_ENDS_H_
