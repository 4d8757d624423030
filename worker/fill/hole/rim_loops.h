// A hole's boundary as closed loops, with the surface beside them.
#ifndef TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_
#define TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/cell_holes.h"
#include "worker/fill/hole/cell_band.h"

namespace tilemend {

// Edge i runs from place i to place i + 1 (the last one to place 0) with the hole on its left, seen from outside. A
// loop may pass a vertex several times.
struct RimLoop {
  std::vector<int32_t> vertices;  // into CellHoles::vertices
  std::vector<Point3> positions;
  std::vector<Eigen::Vector3d> outside;  // unit normal of the original triangle at edge i; zero if there is none

  int32_t size() const { return static_cast<int32_t>(vertices.size()); }
};

// Unit normal of the original triangle at the edge between rim vertices a and b; zero if there is none.
Eigen::Vector3d UnitNormalBeside(const CellHoles& cell, const CellBand& band, int32_t a, int32_t b);

// The loops of a hole. A segment runs on into the one that follows it in the list if that begins where it ends, else
// into any that does. None if the segments do not form loops. O(n log n).
std::vector<RimLoop> LoopsOf(const CellHoles& cell, const CellHole& hole, const CellBand& band);

// The normal of the surface at each place of a loop, evened out: of the normals beside the edges within reach the one
// with the least sum of distances to the others. Zero where there are none. O(rim).
std::vector<Eigen::Vector3d> EvenNormals(const RimLoop& loop);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_RIM_LOOPS_H_
