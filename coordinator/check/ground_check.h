// Whether the ground around holes is where it was asked for.
#ifndef TILEMEND_COORDINATOR_CHECK_GROUND_CHECK_H_
#define TILEMEND_COORDINATOR_CHECK_GROUND_CHECK_H_

#include <span>

#include "absl/status/status.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/rim_ground.h"

namespace tilemend {

// Returns kInvalidArgument, saying what is wrong first, unless the squares around holes are of a metre or more, each
// there once, row by row, and near the vertices of the tile's boundary. So what a worker says decides on water there
// alone. O(n).
absl::Status CheckRimGround(const RimGround& rim, std::span<const Point3> vertices);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_GROUND_CHECK_H_
