// Finds the holes of a cell that reach its grid boundary.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_OPEN_HOLES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_OPEN_HOLES_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_site.h"
#include "coordinator/plan/hole/planar_regions.h"

namespace tilemend {

struct OpenHoles {
  // Where a hole lies.
  struct Place {
    size_t regions;     // into `regions`
    int32_t component;  // of them
    size_t hole;        // into `holes`
  };
  std::vector<PlannedHole> holes;
  std::vector<PlanarRegions> regions;
  std::vector<Place> places;  // of the holes that are regions: those whose boundary does not cross itself
};

// One hole for each region that boundary.open bounds, by Wang 2021, 3.1 (types A to D, I and II). If the segments cross
// somewhere, each connected group of them is handled on its own, so that a bad hole fails alone. A group that forms
// loops is a hole whose folds the filler cuts off; another one fails.
OpenHoles FindOpenHoles(const HoleSite& site, const CellBoundary& boundary);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_OPEN_HOLES_H_
