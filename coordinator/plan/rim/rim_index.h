// Finds rim edges and points near a place.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_RIM_INDEX_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_RIM_INDEX_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/vertex_lists.h"
#include "coordinator/plan/rim/grown_sizes.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// A uniform grid over the rim edges, seen from above. Answers are in order of the edges. The rim must outlive the
// index.
class RimIndex {
 public:
  explicit RimIndex(const Rim& rim);

  // Edges that may touch the box [lo, hi] (a superset), each once, ascending.
  std::vector<int32_t> EdgesIn(const Point2& lo, const Point2& hi) const;

  // The edge between two points, either way round; -1 if there is none. Of several the first.
  int32_t EdgeBetween(int32_t a, int32_t b) const;

  // Whether the open segment between p and q stays inside the hole. It must meet no rim edge, and leave from rim points
  // into a hole's corner. The rim points at the ends are `p_point` and `q_point`, or -1.
  bool IsFree(const Point2& p, int32_t p_point, const Point2& q, int32_t q_point) const;

  // Distance to the nearest rim edge, at most `limit`.
  double Distance(const Point2& p, double limit) const;

  // Minimum over the points v of rim edges of size(v) + growth * |p - v|, at most `limit`.
  double SizeAt(const Point2& p, double growth, double limit) const { return sizes_.At(p, growth, limit); }

  // Whether there is surface at p: its winding number in the rim is positive, or it lies on the rim within `tolerance`.
  bool InSurface(const Point2& p, double tolerance) const;

  // The rim point nearest to p within `radius`, or -1.
  int32_t NearestPoint(const Point2& p, double radius) const;

  double mean_size() const { return mean_size_; }

 private:
  Point2 At(int32_t point) const { return rim_.points[point].position.head<2>(); }
  std::vector<std::pair<int32_t, int32_t>> Corners() const;
  int32_t Before(const std::vector<int32_t>& loop, size_t k) const;
  int32_t After(const std::vector<int32_t>& loop, size_t k) const;
  bool LeavesIntoHole(int32_t point, const Point2& direction) const;

  const Rim& rim_;
  double mean_size_;
  BinGrid bins_;      // of the edges
  GrownSizes sizes_;  // of the points
  // The points before and after a point along a loop, elsewhere seen from above.
  std::vector<std::pair<int32_t, int32_t>> corners_;
  VertexLists corners_at_;  // of each point
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_RIM_INDEX_H_
