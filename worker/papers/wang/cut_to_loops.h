// Cuts a region of the plane into parts that one loop each bounds.
#ifndef TILEMEND_WORKER_PAPERS_WANG_CUT_TO_LOOPS_H_
#define TILEMEND_WORKER_PAPERS_WANG_CUT_TO_LOOPS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/lattice.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

struct CutRegion {
  std::vector<std::vector<int32_t>> loops;  // of points, the part on the left; along a bridge a loop passes twice
  int32_t cuts = 0;                         // of loops that were too long
};

// Islands are tied to the rest by bridges, the shortest edges of the triangulation that do. A loop of more than
// `longest` points is cut along the edge that leaves the most even halves, and so on.
//   triangulation  of the region, without conflicts or points that no segment uses: its edges cross nothing. Segments
//                  inside, there in both directions, count to the boundary
//   longest        at least 3
// O(n log n), and O(n) for each cut.
CutRegion CutToLoops(const RegionTriangulation& triangulation, std::span<const LatticePoint> points, int32_t longest);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_CUT_TO_LOOPS_H_
