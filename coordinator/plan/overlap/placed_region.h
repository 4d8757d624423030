// What a tile covers together with what lies outside the area, and where its vertices are.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PLACED_REGION_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PLACED_REGION_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/lattice.h"
#include "common/mesh/winding/wound_region.h"
#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/area_outside.h"

namespace tilemend {

// Of all vertices of a tile and all points outside the area, in a box from `lo` to `hi` at least.
inline LatticeWindow WindowAround(Point2 lo, Point2 hi, const SurveyRecord& tile, const AreaOutside& outside) {
  for (const BoundaryVertex& v : tile.vertices) {
    lo = lo.cwiseMin(v.position.head<2>());
    hi = hi.cwiseMax(v.position.head<2>());
  }
  for (const Point2& p : outside.points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  return {lo, hi};
}

// A region whose vertices are points, then corners.
struct PlacedRegion {
  const LatticeWindow& window;
  std::span<const LatticePoint> points;
  int32_t tile_points;  // the first so many are the tile's, the others lie outside the area
  size_t tile_edges;    // likewise of the edges that the region was found from
  WoundRegion region;

  bool IsCorner(int32_t v) const { return v >= std::ssize(points); }
  const RegionCorner& CornerOf(int32_t v) const { return region.corners[v - std::ssize(points)]; }
  LatticePoint At(int32_t v) const { return IsCorner(v) ? CornerOf(v).place : points[v]; }
  Point2 PlaceOf(int32_t v) const { return window.ToMetres(At(v)); }

  bool IsOfTile(int32_t edge) const { return edge < static_cast<int32_t>(tile_edges); }
  // Whether a vertex is one of those outside the area, or lies between two of them.
  bool IsOnOutside(int32_t v) const {
    if (!IsCorner(v)) return v >= tile_points;
    return std::ranges::any_of(CornerOf(v).through, [&](int32_t e) { return !IsOfTile(e); });
  }
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PLACED_REGION_H_
