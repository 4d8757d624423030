// What holes are found in.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_SITE_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_SITE_H_

#include <functional>
#include <set>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

// All of it must outlive the site.
struct HoleSite {
  const std::set<CellId>& area;  // beyond it an open hole is external
  const GridLines& lines;
  const Rim& rim;
  const std::vector<Point3>& position;  // of the rim points, then of the seam vertices (heights mean nothing there)
  const std::function<bool()> is_cancelled = {};  // as in PlanOptions
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_HOLE_SITE_H_
