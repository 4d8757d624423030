// How good the triangles of patches are.
#ifndef TILEMEND_WORKER_FILL_SHAPE_PATCH_QUALITY_H_
#define TILEMEND_WORKER_FILL_SHAPE_PATCH_QUALITY_H_

#include <vector>

#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"

namespace tilemend {

// Tallies the triangles of all patches. A poor one is forced by the rim if its corners are all original vertices.
// Examples are three rim vertices nearly on a line, and an angle between two rim edges. It is also forced if its
// shortest edge is an original one (a needle on a rim edge far shorter than its neighbours). The filler may neither
// move nor split these.
QualityTally TallyQuality(const CellHoles& cell, const std::vector<HolePatch>& patches);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_PATCH_QUALITY_H_
