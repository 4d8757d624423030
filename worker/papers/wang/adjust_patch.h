// Mesh adjustment: the step of Wang 2021 between refinement and fairing.
#ifndef TILEMEND_WORKER_PAPERS_WANG_ADJUST_PATCH_H_
#define TILEMEND_WORKER_PAPERS_WANG_ADJUST_PATCH_H_

#include "worker/fill/shape/new_patch.h"

namespace tilemend {

// Moves every new point to the mean of its first and second neighbours (Wang 2021, 3.3, eq. 1). Each neighbour is
// weighted by the reciprocal of its distance. It goes ring by ring from the rim inward, the neighbours of the rim
// first. All points of one ring move from the places that the points have before it. Points of the surroundings count
// as neighbours. A move that would turn a triangle over on the plane is shortened (PointMover). O(n times the second
// neighbours).
void AdjustPatch(const PatchSurroundings& around, NewPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_ADJUST_PATCH_H_
