// How much memory it takes to fill holes, foretold from their boundaries.
#ifndef TILEMEND_WORKER_FILL_FILL_MEMORY_H_
#define TILEMEND_WORKER_FILL_FILL_MEMORY_H_

#include <cstdint>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// About how many new vertices the patch of a hole gets. It takes triangles as large as those of its boundary over its
// area, or as they grow inward from it. Linear in the boundary.
double ExpectedVertices(const CellHoles& cell, const CellHole& hole, const RefineOptions& options);

// Bytes that FillHoles takes at most at a time, and SampleCluster of the same holes. No more vertices count than
// options.refine.max_new_points, where FillHoles stops. By measurement:
// docs/decisions/2026-11-25-memory-of-tasks.md.
int64_t FillMemory(const CellHoles& cell, const FillOptions& options);
int64_t SampleMemory(const CellHoles& cluster, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_FILL_MEMORY_H_
