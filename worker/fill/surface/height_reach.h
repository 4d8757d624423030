// Between which heights a surface is to stay.
#ifndef TILEMEND_WORKER_FILL_SURFACE_HEIGHT_REACH_H_
#define TILEMEND_WORKER_FILL_SURFACE_HEIGHT_REACH_H_

#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

struct HeightReach {
  double lo = 0, hi = 0;  // metres
  double extent = 0;      // of the patch, metres

  bool Holds(double height) const { return height >= lo && height <= hi; }
  bool HoldsUnknown(const ThinPlateProblem& problem) const;
};

// Above and below the rim: half the range of its heights, and a quarter of the extent times the median slope beside it.
// Walls do not count for the slope. O(n).
HeightReach ReachOfRim(const ThinPlateProblem& problem);

// Whether a triangle is ground and no wall: no steeper than 5 in 1, and faces up.
bool IsGround(const ThinPlateProblem& problem, const Triangle& t);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_HEIGHT_REACH_H_
