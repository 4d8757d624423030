// Fills a hole whose boundary crosses itself on its plane.
#ifndef TILEMEND_WORKER_FILL_PLANE_FOLDED_FILL_H_
#define TILEMEND_WORKER_FILL_PLANE_FOLDED_FILL_H_

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {

// A boundary that runs over facades, under trees or along upright edges folds over itself on the plane. What it winds
// around is filled over the plane (wound_region.h, plane_fill.h), with a new vertex wherever the boundary crosses
// itself. No vertex at a fold has an equation. The new vertex lies on the ground where walls stand (upright_walls.h),
// else below the lower of the edges there. Parts of the region that no edge of the hole bounds are left out. What lies
// between that region's boundary and the hole's, walls for the most part, is closed by triangles in space, loop by
// loop. If possible they cross neither the surface of `check` nor the patch.
//
// The patch is closed whatever the folds; it may yet pass through itself or the surface there (mend_crossings.h).
// Failures as FillOverPlane. Cost as FillOverPlane, and cubic in the longest loops up to a bound.
LocalPatch FillFolded(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                      CrossingCheck& check);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PLANE_FOLDED_FILL_H_
