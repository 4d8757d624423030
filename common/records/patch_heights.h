// Heights that the surface of Wang 2021 gets before and after its patches are made.
#ifndef TILEMEND_COMMON_RECORDS_PATCH_HEIGHTS_H_
#define TILEMEND_COMMON_RECORDS_PATCH_HEIGHTS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// Gives vertices without a height the mean of the samples of their seam vertex, or of the one that they follow, on the
// lattice. Columns of one length; several samples of one vertex come from several holes. O(n log n).
void TakeSampledHeights(std::span<const int32_t> seam_vertex, std::span<const double> height, CellHoles& holes);

// Moves points to their new heights: of several for one point to the mean, on a lattice of `step` metres.
// Precondition: the points are there.
void MoveSmoothedPoints(std::span<const std::vector<SmoothedPoint>> moves, double step,
                        std::vector<HolePatch>& patches);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_PATCH_HEIGHTS_H_
