// The tension of a thin-plate surface: the likeliest for the heights of the rim.
#ifndef TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
#define TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_

#include "common/records/cell_holes.h"
#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// A smaller rim is not tested for a tension, or not even for noise.
inline constexpr int kLeastRimForHoldOut = 64, kLeastRimForNoise = 20;

// Chooses the tension for `problem` (its own is ignored) from the heights of its rim and of the vertices beside it, by
// how well the thin plate with each candidate tension foretells them (kriging.h). Candidates are 0 and steps of a
// ladder of 1 / width^2, tried from 10 / width^2 on as long as they score better. The score is the log-likelihood of
// the heights, less 1 for each step of the ladder: a step must make the heights e times as likely. Each height has a
// variance of its own, noise, the likeliest at 10 / width^2.
//
// Where the largest noise of its ladder is as likely as that, to within a step, the rim is rough but even at large: its
// slopes go on nowhere, and the tension is 1e5 / width^2, a membrane's.
//
// HoldOut tells beside it what the choice is worth: stretches of the rim, about as long as the hole is wide, are left
// out in turn and foretold from the rest.
//
// The problem's known points with an equation are its rim, its band's other points lie beside it. A rim of fewer than
// kLeastRimForHoldOut points (of kLeastRimForNoise where it is all noise), or too short for several blocks, gets
// tension 0 untested; so does one in a plane. The choice does not depend on the order of points. Cost bounded: at most
// 100 rim points are looked at.
//   width  of the hole, metres (hole_width.h); 0: not tested
HoldOut ChooseTension(const ThinPlateProblem& problem, double width);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
