// Second-order fairing of a patch in space.
#ifndef TILEMEND_WORKER_PAPERS_WANG_FAIR_PATCH_H_
#define TILEMEND_WORKER_PAPERS_WANG_FAIR_PATCH_H_

#include <cstdint>
#include <functional>

#include "worker/fill/shape/new_patch.h"

namespace tilemend {

// Mesh fairing (Wang 2021, 3.3) moves new points in space towards U^2(v) = 0. It takes the second-order weighted
// umbrella operator (eq. 2 and 4). The cotangent weights are those of the surface before each step (eq. 3).
//
// The paper does not say how eq. 4 is brought to zero. Each step here is one of the flow dv/dt = -U^2(v), implicit as
// in the paper's reference 20 (Desbrun et al. 1999). Its equation is (1 + kFairingStep U^2) v' = v. So a few steps take
// out what is rough and leave of the adjusted shape what is broad; many end at U^2 = 0. In U^2 at a new point, U of its
// neighbours is theirs. At points of the rim it comes from patch and surroundings, and is 0 where these do not surround
// them (on seams):
// there the patch bends freely. A move that would turn a triangle over on the plane is shortened (PointMover).
//
// False, with the points as after the last step that was solved, if one could not be, or `is_cancelled` says so before
// or in it (none: never). Sparse Cholesky; about O(n^1.5) a step.
bool FairPatch(const PatchSurroundings& around, int32_t steps, NewPatch& patch,
               const std::function<bool()>& is_cancelled = {});

inline constexpr double kFairingStep = 1000;

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_FAIR_PATCH_H_
