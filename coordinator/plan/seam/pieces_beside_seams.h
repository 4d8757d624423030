// Detached pieces of the surface that seams run around.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_PIECES_BESIDE_SEAMS_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_PIECES_BESIDE_SEAMS_H_

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/seam/seam_layout.h"
#include "coordinator/plan/seam/seam_site.h"

namespace tilemend {

// On a ragged cut a small piece of surface may lie across a grid line although one cell closes on all of its outline.
// A seam bends around it on one side or the other. The outline then goes to the cell on the side of the seam where the
// piece lies. The edges that the seam itself follows are for CloseAlongSeams (seams_along_rim.h), which comes after.
// Cost O(n log n) in the edges and the seams' vertices.
void GivePiecesToTheirSide(const SeamSite& site, const SeamLayout& layout, ClosingCells& closing);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_PIECES_BESIDE_SEAMS_H_
