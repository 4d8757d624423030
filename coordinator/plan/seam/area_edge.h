// Where the edge of an area polygon runs through holes.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_AREA_EDGE_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_AREA_EDGE_H_

#include <vector>

#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/seam/seam_site.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct AreaCut {
  Rim rim;
  std::vector<LeftOpen> left;  // where the edge could not be followed; parts left out inside a hole, which are filled
};

// The rim of what is left to be covered: `site.rim` inside the polygon `input.area`. Where the polygon runs through
// holes, chains of new edges along it (RimEdge::area_edge) close the rim. So all that lies outside counts as surface,
// and what bounds surface there bounds no hole.
//
// A chain begins and ends at rim vertices outside the polygon, or within kOnLine of it. An edge of the surface that the
// polygon crosses stays whole, and the fill reaches over the polygon by less than that edge. If no way leads there it
// takes vertices inside. New vertices lie on the polygon and on the lattice. They are at its corners, at grid lines,
// and between as far apart as the triangles there will be large. None are nearer than a fraction of that to each other
// or to the rim. They have index -1 and no height.
//
// Precondition: the polygon has rings, and they do not cross. Cost: the rim's points times the polygon's, and the paths
// (seam_path.h).
AreaCut CutByArea(const SeamSite& site, const PlanInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_AREA_EDGE_H_
