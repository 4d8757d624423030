// Which way the surface around a hole faces.
#ifndef TILEMEND_WORKER_FILL_HOLE_FACING_H_
#define TILEMEND_WORKER_FILL_HOLE_FACING_H_

#include <Eigen/Core>

#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// The sum of the normals of the surface that goes on into the hole.
Eigen::Vector3d FacingOf(const LocalHole& hole);

// The unit direction that makes the least angle with all normals beside the rim: if any plane has no overhangs at the
// rim, the one across it. (Badoiu and Clarkson 2003: steps of 1 / k to the normal furthest away.)
Eigen::Vector3d WidestView(const LocalHole& hole);

// Whether the surface around the hole is too steep over the plane that it faces for triangles that are well shaped
// there to be well shaped in space.
bool IsSteep(const LocalHole& hole);

// Whether all band triangles at the hole face up.
bool FacesUp(const LocalHole& hole);

// Whether the hole is one in a height field: then heights fill it without a fold. O(n log n).
bool LiesInHeightField(const LocalHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_FACING_H_
