// Rim edges that seams run along.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAMS_ALONG_RIM_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAMS_ALONG_RIM_H_

#include <span>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/seam/seam_site.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Where a seam follows a rim edge, that edge bounds the cell on whose side of the seam the hole lies. It goes to that
// cell. Near a grid corner several seams may follow one edge: each takes it from the cell on its one side to that on
// its other. An edge leaves the area only along the area's own border.
void CloseAlongSeams(const SeamSite& site, std::span<const Seam> seams, ClosingCells& closing);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAMS_ALONG_RIM_H_
