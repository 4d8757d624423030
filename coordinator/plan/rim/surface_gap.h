// How far apart the surfaces of two tiles are where both lie over one strip of ground.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_SURFACE_GAP_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_SURFACE_GAP_H_

#include <optional>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/tri_mesh.h"
#include "coordinator/plan/types/cell_side.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The triangles of a mesh that reach into a strip along a border: between `lo` and `hi` on the axis across it. The mesh
// must outlive it.
class StripSurface {
 public:
  StripSurface(const TriMesh& mesh, int axis, double lo, double hi);

  // From `p` to the nearest triangle in space; nothing if none is within a metre. O(triangles near p).
  std::optional<double> Distance(const Point3& p) const;
  // From `p` straight up or down to the nearest triangle; nothing if none is over or under it. O(triangles near p).
  std::optional<double> HeightDifference(const Point3& p) const;

 private:
  const TriMesh& mesh_;
  const std::vector<Triangle> triangles_;
  const BinGrid bins_;
};

// A tile and where its own straight outline lies on the axis across a border, metres.
struct TileOutline {
  const SurveyRecord& record;
  double coordinate = 0;
};

// The distances in space of each tile's outline vertices from the other tile's surface, by the triangles of its band
// there. A vertical distance would say metres of two facades that are centimetres apart. What is farther than a metre
// is not the same surface. But if most of what lies over the other tile is so, the tiles disagree, and the differences
// in height count as well. Cost linear in the bands, and for each vertex in the triangles near it.
//   axis  across the border
SurfaceGap MeasureGap(const TileOutline& a, const TileOutline& b, int axis);

SurfaceGap SummaryOf(std::vector<double> distances);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_SURFACE_GAP_H_
