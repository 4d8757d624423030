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

// 4.1 (1): no two sides differ in direction, either way round, by more than 10 degrees, nor does any side from the
// first by more than that when the turns between are added up, about the surface's normal. O(n^2), but soon done on
// loops that are no cracks.
bool IsCrack(const LoopLine& loop);

// The median over the corners of the distance to the nearest side that does not end there, over the mean length of the
// two sides that do: how wide a hole is. O(n^2) up to a thousand corners; then linear, by as many of them.
double MedianWidth(const LoopLine& loop);

// 4.1 (2), with MedianWidth in place of millimetres; or, where `width` is given, with that in the mesh's own units.
struct DislocationLimit {
  double in_edges = 0.2;
  double length = 0;  // 0: not asked for
};
bool IsDislocation(const LoopLine& loop, const DislocationLimit& limit);

// 4.1 (3): two loops that face each other: one is about as long as the other, and opens the other way. They are the
// ends of a tube that lacks a segment: the surfaces along them face the same way and go away from each other, and the
// gap is no longer than twice the tube's width. Or they nearly coincide. Or they are the rims of a wall's two sides,
// which face opposite ways, no further apart than half the rim's radius: of
// two pieces of surface, since through one piece that would be a tunnel. O(n) times up to a thousand corners.
bool FaceEachOther(const LoopLine& a, const LoopLine& b, bool one_piece);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_LOOP_KINDS_H_
