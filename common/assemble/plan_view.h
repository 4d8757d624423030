// Triangles seen from above, to ask what lies on them or near them.
#ifndef TILEMEND_COMMON_ASSEMBLE_PLAN_VIEW_H_
#define TILEMEND_COMMON_ASSEMBLE_PLAN_VIEW_H_

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Building is O(n); a question costs what lies near.
class PlanView {
 public:
  explicit PlanView(std::vector<SpaceTriangle> triangles);

  // Whether a triangle lies above or below `p`, its sides included. Triangles that stand upright do not count.
  bool Covers(const Point2& p) const;
  // Whether the box of a triangle meets `box`.
  bool Meets(const Eigen::AlignedBox2d& box) const;

 private:
  const std::vector<SpaceTriangle> triangles_;
  Eigen::AlignedBox2d extent_;
  std::optional<BinGrid> grid_;  // none without triangles
};

// The triangles of a mesh by the positions of their corners.
std::vector<SpaceTriangle> CornersOf(const TriMesh& mesh);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_PLAN_VIEW_H_
