// Whether patches are what was asked for.
#ifndef TILEMEND_COORDINATOR_CHECK_PATCH_CHECK_H_
#define TILEMEND_COORDINATOR_CHECK_PATCH_CHECK_H_

#include <vector>

#include "absl/status/status.h"
#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"

namespace tilemend {

// kInvalidArgument, saying what is wrong first, unless
//  - there is exactly one patch for each hole of `asked`;
//  - a patch with a failure has no geometry, and any other
//     - has each rim segment of its hole in one triangle, in its direction, and each other edge in two, once each way:
//       so it closes the hole, is oriented like the surface around it, and has no triangle twice. Where the hole ends
//       at the tile's own outline, the patch may end beside it (MayMoveOutline);
//     - has only finite new vertices, no further from its hole than the hole is large (from the heights of its water,
//     if
//       it is water);
//  - `quality` counts their triangles.
// The band of `asked` is not needed. Precondition: corners are in range. O(n log n) in the triangles.
absl::Status CheckPatches(const CellHoles& asked, const std::vector<HolePatch>& patches, const QualityTally& quality);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_PATCH_CHECK_H_
