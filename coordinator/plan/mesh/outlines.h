// Which boundary loops of a mesh are the outlines of sheets, and no holes.
#ifndef TILEMEND_COORDINATOR_PLAN_MESH_OUTLINES_H_
#define TILEMEND_COORDINATOR_PLAN_MESH_OUTLINES_H_

#include <span>
#include <vector>

#include "coordinator/plan/mesh/mesh_loops.h"

namespace tilemend {

// Marks the outlines. A piece of surface has at most one outline, together with the loops that touch it and run round
// the piece as it does. Slits are excepted: if the two sides of a crack overlap, its loop runs so as well.
//
// How open a piece is: the length of the mean of its unit normals. By Stokes that is the vector area of its loops
// together, divided by its own area. A flat sheet has 1, a hemisphere 1/2, a body with holes the share of its surface
// that is missing on one side. Of an open piece, the loop that opens it most is its outline, if the surface along it
// says so too. A cut through a limb that widens runs round it the wrong way, but the body beyond is closed.
//
//   piece_areas  by MeshLoop::piece
std::vector<bool> FindOutlines(std::span<const MeshLoop> loops, std::span<const double> piece_areas);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_OUTLINES_H_
