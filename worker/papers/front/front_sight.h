// What a front has near a new triangle.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_FRONT_SIGHT_H_
#define TILEMEND_WORKER_PAPERS_FRONT_FRONT_SIGHT_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/papers/front/front_index.h"
#include "worker/papers/front/front_loops.h"

namespace tilemend {

// Each question costs as much as there is of the front near by. Loops and points must outlive it.
class FrontSight {
 public:
  FrontSight(const FrontLoops& loops, const std::vector<Point3>& points)
      : loops_(loops), points_(points), index_(loops) {}

  // The edge that leaves a node is new, or has a new end: to be said of every edge before it is seen.
  //   unit  the length of edges here, > 0
  void Follow(int32_t node, double unit);

  // Whether a triangle faces with `normal` and, seen along its own normal, covers no vertex of the front. Nor may it
  // cross part of an edge of the front that is no further off than its own longest edge.
  //   vertices  of its corners; -1: a new one
  bool IsClear(const SpaceTriangle& t, const Triangle& vertices, const Eigen::Vector3d& normal) const;

  // Whether an edge of the front, but for those at the vertex of `node`, is nearer to a place than that.
  bool IsNear(const Point3& p, int32_t node, double distance) const;

  // The nodes no further from a place than that, rising.
  std::vector<int32_t> NodesNear(const Point3& p, double distance) const;

  // How many edges were looked at in all (FrontIndex).
  int64_t looked_at() const { return index_.looked_at(); }

 private:
  const Point3& At(int32_t node) const { return points_[loops_[node].vertex]; }

  const FrontLoops& loops_;
  const std::vector<Point3>& points_;
  FrontIndex index_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_FRONT_SIGHT_H_
