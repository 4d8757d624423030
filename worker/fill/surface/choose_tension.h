// The tension of a thin-plate surface, the likeliest for the heights of the rim; told beside it, a hold-out error.
#ifndef TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
#define TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_

#include <span>

#include "common/mesh/triangulation/region_triangulation.h"
#include "common/records/cell_holes.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {

// Chooses the tension for `problem` (its own is ignored) from the heights of its rim and of the vertices beside it, as
// the thin plate with each candidate tension would foretell them on an unbounded plane: kriging with a linear drift and
// the fundamental solution of Laplacian^2 - t Laplacian,
//   r^2 ln r / (8 pi)                             for t = 0,
//   -(ln r + K0(sqrt(t) r)) / (2 pi t)            for t > 0
// (Wahba 1990; Mitas and Mitasova 1988). Candidates are 0 and ladder steps of 1 / width^2, tried from 10 / width^2 on
// as long as they score better. The score is the restricted log-likelihood of the heights (Patterson and Thompson
// 1971), the sum of the log-probabilities with which each is foretold from those before it, less 1 for each step of the
// ladder: a step must make the heights e times as likely. Each height has a variance of its own, noise, the likeliest
// at 10 / width^2.
// What the choice is worth is told by a second hold-out:
// stretches of the rim, about as long as the hole is wide, are left out in turn and foretold from the rest. Leaving a
// block B out costs no further solve: its error is (C_BB)^-1 (C z)_B with C the inverse of the kriging matrix (Dubrule
// 1983).
//
// The problem's known points with a full ring are its rim, its band's other points lie beside it. A rim of fewer than
// kLeastRimForHoldOut points, or too short for several blocks, gets tension 0 untested. The choice does not depend on
// the order of points. Cost bounded: at most 100 rim points are looked at.
//   width  of the hole, metres (HoleWidth); 0: not tested
HoldOut ChooseTension(const ThinPlateProblem& problem, double width);

// How wide the region is that the segments have on their left, seen from above: the diameter of the empty circles in
// which half of its area lies, those about the triangles of its Delaunay triangulation. 0 if they bound no region.
// Depends on the rim alone, not on seams or triangles inside. Cost O(n log n).
double HoleWidth(std::span<const Point3> points, std::span<const RegionSegment> segments);

inline constexpr int kLeastRimForHoldOut = 64;

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_CHOOSE_TENSION_H_
