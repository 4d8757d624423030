// The closed loops of a hole's boundary, with the surface beside them.
#ifndef TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_
#define TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// Edge i runs from place i to place i + 1 (the last one to place 0). The hole is on its left, seen from outside. A loop
// may pass a vertex several times.
struct RimLoop {
  std::vector<int32_t> vertices;
  std::vector<Point3> positions;
  std::vector<Eigen::Vector3d> outside;  // unit normal of the original triangle at edge i; zero if there is none

  int32_t size() const { return static_cast<int32_t>(vertices.size()); }
};

// The vertices of the loops that segments form (LinkEdges). None if they do not form loops. O(n log n).
std::vector<std::vector<int32_t>> LoopsOf(std::span<const RegionSegment> segments);

// The normal of the surface at each place of a loop, evened out. Of the normals beside the edges within reach it is the
// one with the least sum of distances to the others. Zero where there are none. O(rim).
std::vector<Eigen::Vector3d> EvenNormals(const RimLoop& loop);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_
