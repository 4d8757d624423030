// The heights at which a tile ends along a grid line.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_LOWEST_HEIGHTS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_LOWEST_HEIGHTS_H_

#include <functional>
#include <map>

#include "common/mesh/tri_mesh.h"
#include "common/records/survey_record.h"

namespace tilemend {

// Of the boundary's vertices beyond the line: their heights, by their coordinate along it. Vertices above another edge
// beyond the line are left out (kMeetTolerance), as of an eave over the street: a hole ends at the lowest surface
// there.
//   axis    0: the line runs along x, 1: along y
//   beyond  whether a point lies beyond the line
// O(n log^2 n).
std::map<double, double> LowestHeights(const SurveyRecord& record, int axis,
                                       const std::function<bool(const Point3&)>& beyond);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_LOWEST_HEIGHTS_H_
