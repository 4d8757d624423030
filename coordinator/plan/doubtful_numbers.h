// Numbers of a scene that can hardly be metres, or heights.
#ifndef TILEMEND_COORDINATOR_PLAN_DOUBTFUL_NUMBERS_H_
#define TILEMEND_COORDINATOR_PLAN_DOUBTFUL_NUMBERS_H_

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Cells smaller than a square of the ground raster: degrees and kilometres look so. Heights that lie further apart in
// one tile than Mount Everest and the sea: a raster's value for no data has become vertices. O(tiles).
void RemarkOnNumbers(const PlanInput& input, PlanRemarks& remarks);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_DOUBTFUL_NUMBERS_H_
