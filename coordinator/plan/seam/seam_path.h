// A way along a grid line through a hole that does not meet the rim.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_PATH_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_PATH_H_

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"

namespace tilemend {

// A path from way.front() to way.back() over as many of the vertices between as can be reached in order. It bends over
// rim points where the rim stands in between. Consecutive vertices of the path are joined by free segments
// (RimIndex::IsFree) or by rim edges. Vertices below rim.points.size() are rim points. Nothing if there is no such
// path.
std::optional<std::vector<int32_t>> FindSeamPath(const std::vector<int32_t>& way, const Rim& rim, const RimIndex& index,
                                                 const std::function<Point2(int32_t)>& position);

// The same path, bent over rim points that lie beside one of its edges. They lie within a fifth of the edge's length
// and within `reach` (metres), and both halves are free or rim edges. Beside a straight edge there would be triangles
// too flat for use. No vertex comes up twice that did not before.
std::vector<int32_t> BendToRim(const std::vector<int32_t>& path, const Rim& rim, const RimIndex& index,
                               const std::function<Point2(int32_t)>& position,
                               double reach = std::numeric_limits<double>::infinity());

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_PATH_H_
