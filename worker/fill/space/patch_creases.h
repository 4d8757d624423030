// Edges at which a patch folds back, and bevels in their place.
#ifndef TILEMEND_WORKER_FILL_SPACE_PATCH_CREASES_H_
#define TILEMEND_WORKER_FILL_SPACE_PATCH_CREASES_H_

#include <cstdint>

#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// How many edges of the patch, those on the rim included, turn by more than 120 degrees: what `tilemend check` calls
// creased. O(n log n).
int32_t CountCreases(const LocalHole& hole, const LocalPatch& patch);

// How many vertices of the patch, those on the rim included, are what `tilemend check` calls a spike. The angles around
// a spike come to less than 90 degrees in all. Its edges are in the mean twice as long as those around it. O(n).
int32_t CountSpikes(const LocalHole& hole, const LocalPatch& patch);

// By how much the patch turns against the surface beside it, radians: the mean along the rim. 0 if nothing is beside
// it. O(n).
double TurnAtRim(const LocalHole& hole, const LocalPatch& patch);

// Puts a new vertex off the middle of each crease. So a narrow triangle stands between the two that fold onto each
// other, and takes half the turn. The patch stays sound: bevels that cross anything, or lead to as many creases, are
// not made. O(n log n) beside the check for crossings.
//   patch  sound
LocalPatch BevelCreases(const LocalHole& hole, LocalPatch patch, CrossingCheck& check);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_PATCH_CREASES_H_
