// How much of a hole an area of the user covers.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_

#include <span>
#include <utility>

#include "common/grid/water_areas.h"

namespace tilemend {

using PlaneSegment = std::pair<Point2, Point2>;

// The share, 0 to 1, of the region that `boundary` bounds (even-odd rule, any order) that lies in the area, measured on
// 128 lines across the region. Segments that occur twice, such as seams inside a cluster, bound nothing. Cost O(128 *
// (segments + positions of the area)); much less where the bounding boxes lie apart.
double CoveredShare(std::span<const PlaneSegment> boundary, const WaterArea& area);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_AREA_COVER_H_
