// Where grid boundaries bound a hole.
#ifndef TILEMEND_WORKER_PAPERS_WANG_GRID_STRETCHES_H_
#define TILEMEND_WORKER_PAPERS_WANG_GRID_STRETCHES_H_

#include <cstdint>
#include <vector>

#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// Vertices of a hole along one line, with the hole on the left.
struct GridStretch {
  std::vector<int32_t> vertices;
  std::vector<int32_t> before, after;  // of the boundary, from either end of the stretch on, up to another stretch
  int axis = 0;                        // constant along the line
  double line = 0;                     // metres
  double way = 1;                      // sign along the line, from the first vertex to the last
  double own = 1;                      // sign of the axis on this side of the line

  // How far a place lies from the line on this side.
  double OffLine(const Point2& p) const { return own * (p[axis] - line); }
};

// The stretches of grid boundary around a hole, in order of its loops. Where the hole ends at the tile's own outline,
// the stretch is of that outline. O(n) in the hole's segments.
std::vector<GridStretch> StretchesAround(const LocalHole& hole);

// Replaces each stretch along the tile's outline by the neighbour's outline within the hole (LocalHole::inner_edges),
// if there is one. It has the same ends, and its vertices lie straight across from the stretch's own. O(n log n).
void MoveToNeighbours(const LocalHole& hole, std::vector<GridStretch>& stretches);

// For each vertex of the hole a bit for each side of the cell: whether the vertex bounds the strip there, between the
// tile's outline and the neighbour's. A triangle whose corners have a bit in common lies in that strip. O(n log n).
std::vector<uint8_t> StripsBeside(const LocalHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_GRID_STRETCHES_H_
