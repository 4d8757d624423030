// Fills a hole over a triangulation of least area.
#ifndef TILEMEND_WORKER_PAPERS_WANG_LEAST_AREA_FILL_H_
#define TILEMEND_WORKER_PAPERS_WANG_LEAST_AREA_FILL_H_

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// The filler minimum-area: of all triangulations of the boundary in space the one of least area, whatever it crosses.
// Source: Liepa 2003, 3, without his dihedral angles; Wang 2021, 3.3. Then refinement, adjustment and fairing
// (wang_fill.h:
// ShapeAsWang). Islands are tied to the rest by the shortest bridges (space_fill.h).
//   hole  closed
// A patch may cross itself or the surface: the caller checks it. Failures: a boundary of more than
// options.wang.longest_loop vertices, no bridge, no triangulation without an edge that the surface has.
LocalPatch FillLeastArea(const LocalHole& hole, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_LEAST_AREA_FILL_H_
