// Which way the surface around a hole faces.
#ifndef TILEMEND_WORKER_FILL_HOLE_FACING_H_
#define TILEMEND_WORKER_FILL_HOLE_FACING_H_

#include <Eigen/Core>

#include "worker/fill/hole/local_hole.h"
#include "worker/fill/hole/projection_frame.h"

namespace tilemend {

// The sum of the normals of the surface that goes on into the hole.
Eigen::Vector3d FacingOf(const LocalHole& hole);

// The unit direction that makes the least angle with all normals beside the rim. If any plane has no overhangs at the
// rim, the one across it has none. (Badoiu and Clarkson 2003: steps of 1 / k to the normal furthest away.)
Eigen::Vector3d WidestView(const LocalHole& hole);

// Whether the surface around the hole is steep over the plane that it faces: triangles that are well shaped there are
// not so in space.
bool IsSteep(const LocalHole& hole);

// The plane across `normal` (not zero) that the hole may be filled over. In a mesh that may lie in any way its axes
// turn with the hole.
ProjectionFrame FrameAcross(const LocalHole& hole, const Eigen::Vector3d& normal);

// The plane that heights around the hole are over: the ground. In a mesh that may lie in any way, the plane across the
// widest view.
ProjectionFrame FrameOfHeights(const LocalHole& hole);

// Whether all band triangles at the hole face up over the plane.
bool FacesUp(const LocalHole& hole, const ProjectionFrame& frame);

// Whether the hole is one in a height field over the plane: then heights fill it without a fold. O(n log n).
bool LiesInHeightField(const LocalHole& hole, const ProjectionFrame& frame);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_FACING_H_
