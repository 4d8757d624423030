// What a front has near a new triangle.
#ifndef TILEMEND_WORKER_FILL_FRONT_FRONT_SIGHT_H_
#define TILEMEND_WORKER_FILL_FRONT_FRONT_SIGHT_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/front/front_loops.h"

namespace tilemend {

// O(front) each. Both must outlive it.
class FrontSight {
 public:
  FrontSight(const FrontLoops& loops, const std::vector<Point3>& points) : loops_(loops), points_(points) {}

  // Whether a triangle faces with `normal` and, seen along its own normal, covers no vertex of the front and crosses no
  // edge of it that is no further off than its longest edge.
  //   vertices  of its corners; -1: a new one
  bool IsClear(const SpaceTriangle& t, const Triangle& vertices, const Eigen::Vector3d& normal) const;

  // The distance from a place to the edges of the front but those at the vertex of `node`.
  double DistanceTo(const Point3& p, int32_t node) const;

 private:
  const FrontLoops& loops_;
  const std::vector<Point3>& points_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_FRONT_FRONT_SIGHT_H_
