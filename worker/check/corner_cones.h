// Tells triangles around one vertex apart quickly.
#ifndef TILEMEND_WORKER_CHECK_CORNER_CONES_H_
#define TILEMEND_WORKER_CHECK_CORNER_CONES_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The round cones about the corners of triangles at vertices that very many of them have. Without them, each of the
// triangles around such a vertex would be compared with each. Building: O(n).
class CornerCones {
 public:
  // Triangles have an area.
  CornerCones(std::span<const Point3> points, std::span<const Triangle> triangles);

  // Whether triangles a and b, that have one vertex in common, are known to have nothing else in common, as their cones
  // there have not. False tells nothing. O(1).
  bool AreApart(int32_t a, int32_t b) const;

 private:
  struct Cone {
    Eigen::Vector3d axis;
    double cosine, sine;  // of the angle between axis and side
  };

  std::span<const Triangle> triangles_;
  std::vector<std::array<int32_t, 3>> cone_of_;  // by triangle and corner; -1: few triangles are there. May be empty
  std::vector<Cone> cones_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_CORNER_CONES_H_
