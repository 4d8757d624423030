// Which triangle of a patch over the plane a place lies in.
#ifndef TILEMEND_WORKER_FILL_SEAM_TRIANGLE_FINDER_H_
#define TILEMEND_WORKER_FILL_SEAM_TRIANGLE_FINDER_H_

#include <Eigen/Core>
#include <optional>
#include <span>

#include "common/mesh/box_tree.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct PlaceInTriangle {
  Triangle triangle{};
  Eigen::Vector3d share{0, 0, 0};  // of each corner: barycentric coordinates, seen from above
};

// Finds triangles by places, seen from above. Points and triangles must outlive it. Building: O(n log n).
class TriangleFinder {
 public:
  TriangleFinder(std::span<const Point3> points, std::span<const Triangle> triangles);

  // One that the place lies in, or on an edge of; none outside all of them. Triangles without area seen from above
  // count for nothing. O(log n), and those whose boxes have the place.
  std::optional<PlaceInTriangle> Find(const Point2& place) const;

 private:
  const std::span<const Point3> points_;
  const std::span<const Triangle> triangles_;
  BoxTree boxes_;  // flat
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SEAM_TRIANGLE_FINDER_H_
