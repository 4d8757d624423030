// What seams are laid in.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_SITE_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_SITE_H_

#include <set>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// All of it must outlive the site.
struct SeamSite {
  const std::set<CellId>& area;  // whose holes are to be bounded
  const GridLines& lines;
  const Rim& rim;
  const RimIndex& index;  // of `rim`
  const PlanOptions& options;
  double lattice_step = 0;  // metres
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_SITE_H_
