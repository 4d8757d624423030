// How wide a hole is.
#ifndef TILEMEND_WORKER_FILL_SURFACE_HOLE_WIDTH_H_
#define TILEMEND_WORKER_FILL_SURFACE_HOLE_WIDTH_H_

#include <span>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// How wide the region is that the segments have on their left, seen from above. It is the diameter of the empty circles
// in which half of its area lies: those about the triangles of its Delaunay triangulation. It is 0 if they bound no
// region. Depends on the rim alone, not on seams or triangles inside. Cost O(n log n).
double HoleWidth(std::span<const Point3> points, std::span<const RegionSegment> segments);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_HOLE_WIDTH_H_
