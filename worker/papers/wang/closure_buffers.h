// Topological closure: the buffer zones beside grid boundaries.
#ifndef TILEMEND_WORKER_PAPERS_WANG_CLOSURE_BUFFERS_H_
#define TILEMEND_WORKER_PAPERS_WANG_CLOSURE_BUFFERS_H_

#include <cstdint>
#include <vector>

#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// How the surface boundary meets the grid boundary where a buffer begins, ends or passes (Wang 2021, 3.3, figure 7).
enum class ClosureCase {
  kAcross,    // 1: an edge of the surface boundary has its ends on both sides of the line
  kOnLine,    // 2: a vertex of it lies on the line, its neighbours on both sides
  kTouching,  // 3: a vertex of it lies on the line, both neighbours in the other cell
};

// The points that a hole gets from the boundaries of its buffers, and the edges between them.
struct ClosureBuffers {
  std::vector<Point3> points;
  std::vector<double> sizes;         // wanted edge length at each, metres
  std::vector<RegionSegment> edges;  // hole.size() + k is points[k]
  std::vector<ClosureCase> joints;   // that gave a buffer its width, in order of the hole's loops
};

// Lays the cell's part of the buffer zones along its grid boundaries. Each runs from joint to joint. At a joint it is
// as far off the line as
//   - the boundary points of the joint on this side of the line (cases 1 and 2);
//   - those on the other side, on average (case 3: the zone lies outside the grid boundary of the cell that they belong
//     to).
// In between the width changes evenly. Beyond the last joint, towards a grid corner in the hole, it stays. It is not
// less than half the boundary's edges.
//
// Its points lie opposite those of the grid boundary and have their heights, which were projected. One is selected
// where its triangles will be compact: no edge longer than four widths, nothing of the hole's boundary within 0.4
// widths. The zone is closed to the point of the surface boundary where it begins. A stretch of grid boundary without
// joints has none. O(n log n) in the hole's segments, and for each point the edges laid before; deterministic.
//
// Where tiles overlap, the strip between two outlines is a zone already, with the width that the tiles give it. What
// lies beyond it on this side runs along the neighbour's outline (MoveToNeighbours). It is as far off as the first
// point of the surface boundary beyond it, as in case 1.
//
// Precondition: an open hole, upright.
ClosureBuffers LayClosureBuffers(const LocalHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_CLOSURE_BUFFERS_H_
