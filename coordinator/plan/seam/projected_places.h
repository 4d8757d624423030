// Where new vertices lie on a grid line as Wang 2021 has it.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_PROJECTED_PLACES_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_PROJECTED_PLACES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "coordinator/plan/seam/grid_borders.h"
#include "coordinator/plan/seam/seam_site.h"
#include "coordinator/plan/seam/seam_vertices.h"

namespace tilemend {

// A boundary point that a grid line may take a vertex from.
struct BoundaryPlace {
  Point2 position;
  int32_t rim_point = -1;  // -1: a new vertex on another grid line
  double size = 0;         // metres: how far apart boundary points are here
};

// The rim points within the two cells of a border.
std::vector<BoundaryPlace> RimPlacesBeside(const SeamSite& site, const Border& border);

// The places strictly between two ends of a stretch of a border's line that have boundary points opposite them (Wang
// 2021, 3.3, figure 8). They are on the lattice, in order along the line.
//
// A point gives a place if the way to it straight across lies in the hole. There must also be no point nearer to the
// line that gives one within half the distance of boundary points. Where a boundary runs up to the line, its points
// would crowd there. No place is nearer to the rim than PlaceSeamVertices would allow. Where tiles overlap, none lies
// before a grid corner as far as a tile reaches over the line across. None lies within half the distance of boundary
// points of that either: the strip there has points on its two sides alone. Cost: the points times the edges near their
// ways.
std::vector<SeamPlace> ProjectedPlaces(const SeamSite& site, const Border& border, const Point2& from, const Point2& to,
                                       std::span<const BoundaryPlace> boundary);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_PROJECTED_PLACES_H_
