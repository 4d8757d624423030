// The tension of a thin-plate surface, by cross-validation on the heights of the rim.
#ifndef TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
#define TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_

#include "common/records/cell_holes.h"
#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// Rims of fewer points are not tested.
inline constexpr int kMinRimForHoldOut = 20;

// Chooses the tension for `problem` (its own is ignored) by cross-validation on the heights of its rim and of the
// vertices beside it. Blocks of the rim, as long as the hole is wide and half as long, are left out in turn and
// predicted from the rest. The prediction is kriging with the covariance of the thin plate under that tension
// (kriging.h). The candidates are a ladder from 0 to 1000 / width^2, and 1e5 / width^2, a membrane. The choice has the
// least mean root of the blocks' errors, searched from 300 / width^2 on.
//
// The prediction passes through every height that is kept, and goes on with the slopes there, as the surface does. So
// noise of the rim, white or correlated, raises the errors of the tensions that let slopes go on. The choice is a
// membrane where the rim is rough; on smooth ground it is the plate. The root bounds the weight of outliers: cars,
// walls, trees.
//
// The result has the mean |error| of the blocks beside the choice. The problem's known points with an equation are its
// rim, its band's other points lie beside it. A rim of fewer than kMinRimForHoldOut points, or too short for four
// blocks, gets tension 0 untested; so does one in a plane. If more points of the whole rim are known without an
// equation than with one, an untested rim gets 300 / width^2. The search begins there, too. The choice does not depend
// on the order of points. Cost bounded: at most 100 rim points are looked at, and each of eight candidates takes one
// inverse (Dubrule 1983).
//   width  of the hole, metres (hole_width.h); 0: not tested
HoldOut ChooseTension(const ThinPlateProblem& problem, double width);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
