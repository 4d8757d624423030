// Heights along the grid boundaries of a cell's holes: what a layer hands on to the next.
#ifndef TILEMEND_WORKER_FILL_SEAM_SAMPLE_HEIGHTS_H_
#define TILEMEND_WORKER_FILL_SEAM_SAMPLE_HEIGHTS_H_

#include <cstdint>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// A boundary height sample: the height that one hole gives to one seam vertex, metres.
struct HeightSample {
  int32_t seam_vertex = 0;
  double height = 0;
};

// Height projection transformation (Wang 2021, 3.3, figure 8). Every boundary point of a hole whose height is known is
// projected onto the grid boundaries. A seam vertex takes the height of the point that projects to its place, to within
// the lattice's step. Else it takes what is linear between projections; of several that project to one place, the point
// nearest to the grid line counts. An original boundary point gives the mean height of the centroids of the triangles
// at it, or its own height where a seam begins at it. The corners of the cell part its grid boundary: a seam vertex at
// a corner takes the mean of both sides. Vertices on objects count only where there are no others.
//
// Returns one sample for every seam vertex of unknown height, in order of the holes and of their vertices. Cost O(n log
// n).
std::vector<HeightSample> SampleHeights(const CellHoles& cell);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SEAM_SAMPLE_HEIGHTS_H_
