// Fills a hole, or a part of one, as Wang et al. 2021 do.
#ifndef TILEMEND_WORKER_PAPERS_WANG_WANG_FILL_H_
#define TILEMEND_WORKER_PAPERS_WANG_WANG_FILL_H_

#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"

namespace tilemend {

// Wang 2021, 3.3, over the plane of `frame`, where the hole is closed along its seams already, with projected heights
// (coordinator/plan/seam, worker/fill/seam). The steps are
//   - buffer zones along the seams of open holes (closure_buffers.h, figure 7),
//   - triangulation of least area (minimum_area.h),
//   - refinement (refine_patch.h),
//   - adjustment (adjust_patch.h, eq. 1),
//   - fairing (fair_patch.h, eq. 2 to 4).
//
// The paper's closed loops do not fold. Here no triangle turns over on the plane, from the triangulation to the last
// rounding: so the patch covers no place twice. Islands are tied to the rest by bridges, and loops of more than
// options.wang.longest_loop vertices are cut (cut_to_loops.h; LocalPatch::loop_cuts counts them).
//   may_repeat  edges that the surface has already are no obstacle: over a height field it has none inside. Else the
//               triangulation makes none, or they are split
// New points lie on the scene's lattice where that turns no triangle over, over the upright plane also where the tile's
// number type holds them. It fails if the boundary crosses itself on the plane or has no triangulation there with area
// everywhere. It also fails if a fairing step has no solution, or a triangle turns over however it is rounded.
LocalPatch FillAsWang(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, bool may_repeat);

// The same steps after the triangulation, in space, where no plane decides: `triangles` are those of the hole's
// boundary (space_fill.h).
LocalPatch ShapeAsWang(const LocalHole& hole, std::vector<Triangle> triangles, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_WANG_FILL_H_
