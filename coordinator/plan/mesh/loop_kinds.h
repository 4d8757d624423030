// Zhang 2022, 4: which single hole a loop bounds, in lengths of its own edges.
#ifndef TILEMEND_COORDINATOR_PLAN_MESH_LOOP_KINDS_H_
#define TILEMEND_COORDINATOR_PLAN_MESH_LOOP_KINDS_H_

#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The corners of a loop in order, with the unit normals of the surface there.
struct LoopLine {
  std::vector<Point3> corners;
  std::vector<Eigen::Vector3d> normals;
};

// By 4.1 (1): no two sides differ in direction, either way round, by more than 10 degrees. Nor does any side from the
// first, when the turns between are added up, about the surface's normal. O(n^2), but soon done on loops that are no
// cracks.
bool IsCrack(const LoopLine& loop);

// How wide a hole is: the median, over the corners, of the distance to the nearest side that does not end there. It is
// divided by the mean length of the two sides that do. O(n^2) up to a thousand corners; then linear, by as many of
// them.
double MedianWidth(const LoopLine& loop);

// 4.1 (2), with MedianWidth in place of millimetres; or, where `width` is given, with that in the mesh's own units.
struct DislocationLimit {
  double in_edges = 0.2;
  double length = 0;  // 0: not asked for
};
bool IsDislocation(const LoopLine& loop, const DislocationLimit& limit);

// By 4.1 (3): two loops that face each other. One is about as long as the other, and opens the other way. They may be
// the ends of a tube that lacks a segment. Then the surfaces along them face the same way and go away from each other,
// and the gap is at most twice the tube's width. Or they nearly coincide. Or they are the rims of a wall's two sides,
// which face opposite ways, no further apart than half the rim's radius. These must be of two pieces of surface, since
// through one piece that would be a tunnel. O(n) times up to a thousand corners.
bool FaceEachOther(const LoopLine& a, const LoopLine& b, bool one_piece);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_LOOP_KINDS_H_
