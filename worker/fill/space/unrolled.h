// A disc of triangles in space, unrolled into the plane.
#ifndef TILEMEND_WORKER_FILL_SPACE_UNROLLED_H_
#define TILEMEND_WORKER_FILL_SPACE_UNROLLED_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A disc of triangles over a loop, without vertices inside. Each triangle keeps its shape in the plane, so that the
// disc may come to cover itself there.
class Unrolled {
 public:
  // Precondition: the triangles are joined by edges, with corners among the positions and area. O(n log n).
  Unrolled(std::vector<Point3> positions, std::vector<Triangle> triangles);

  // Where each position lies in the plane.
  const std::vector<Point2>& flat() const { return flat_; }

  // The point of the disc in space that lies at p: in the triangle that p is in or least outside of. O(n).
  Point3 Lift(const Point2& p) const;

 private:
  void Place(int32_t a, int32_t b, int32_t c);
  Eigen::Vector3d Weights(const Triangle& t, const Point2& p) const;

  std::vector<Point3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<Point2> flat_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_UNROLLED_H_
