// Where the new vertices of a seam lie.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_VERTICES_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_VERTICES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "coordinator/plan/seam/grid_borders.h"
#include "coordinator/plan/seam/seam_site.h"

namespace tilemend {

// Places this near one another are one, metres. A few steps of float32 at a few hundred metres.
inline constexpr double kSamePlace = 2e-5;

// More edges than that along one seam are refused: a mesh of such edges does not go with cells of such a size. Nobody
// could fill a hole with that many vertices on one side either.
inline constexpr int64_t kMostSeamEdges = 100'000;

// A place on a line, and the rim point a hair beside it of which it takes the height; -1: none.
struct SeamPlace {
  Point2 position;
  int32_t beside = -1;
};

// The wanted edge length at a place, metres: it grows from the rim inward (PlanOptions). Where tiles overlap it is at
// most half the distance to the rim, or a tenth of the mean size at the rim.
double SeamSizeAt(const SeamSite& site, const Point2& p);

// Places between two points, spaced evenly by the wanted edge length, or wider where there would be more than
// kMostSeamEdges edges; not on the lattice.
std::vector<Point2> SpacedBetween(const SeamSite& site, const Point2& from, const Point2& to);

// The places strictly between two ends of a stretch of a border's line, in order along it. They are spaced by the
// wanted edge length and clear of the rim. At the rim of the area a seam must keep to the line. There each rim point
// that lies within kOnLine of the line, but not on it, also has a place opposite. A straight edge there would be the
// base of upright hairline triangles. None if there would be more than `most` edges, or once the plan is cancelled.
// Cost in proportion to the places and the edges near them.
std::optional<std::vector<SeamPlace>> PlaceSeamVertices(const SeamSite& site, const Border& border, const Point2& from,
                                                        const Point2& to, int64_t most = kMostSeamEdges);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_VERTICES_H_
