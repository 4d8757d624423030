// The wanted edge lengths at the rim, where those of its own edges are of no use.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_RIM_SIZES_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_RIM_SIZES_H_

#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// New vertices lie on a lattice of `lattice_step` metres: triangles of a few steps would be bent by rounding. Raises
// sizes below 64 steps to that, or to half the mean size of the points on edges if this is less. (Clipped tiles have
// slivers along their borders, with edges far below a millimetre.)
void RaiseSmallSizes(double lattice_step, Rim& rim);

// Raises sizes at short runs of short edges between long ones. The size is 0.6 of a long edge's length less the way
// from it along the loop. A short edge between long ones makes one triangle poor, whatever is done. Triangles of its
// size around it would make those on the long edges poor as well, and many of them.
void RaiseSizesAtShortEdges(Rim& rim);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_RIM_SIZES_H_
