// Ground with walls in it: the surface of a hole between objects.
#ifndef TILEMEND_WORKER_FILL_SURFACE_WALLED_GROUND_H_
#define TILEMEND_WORKER_FILL_SURFACE_WALLED_GROUND_H_

#include <cstdint>
#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/fill/surface/thin_plate_problem.h"

namespace tilemend {

// What the height of a point on the rim says of the ground.
enum class RimReading : uint8_t {
  kFixed,    // the surface passes through it
  kReading,  // it is the ground, or stands on it
  kNothing,
};

// The ground around a hole, from the triangles of the band that are no walls: the median slope, and the median
// steepness beside that, from 2 to 10 %; 10 % where the band has no ground. O(n log n).
GroundTrend TrendOf(const ThinPlateProblem& problem);

// Whether such a surface is looked for: a twentieth of the rim's original vertices or more stand on objects, and the
// rim did not choose a plate without tension. A rim that was not tested, as most of it stands on objects, has a tension
// as well. Where the ground is steeper than 10 %, what the filter took for objects may be its own slope. O(rim).
//   chosen  what ChooseTension said
//   trend   rise / run; level where the band has no ground
bool HasWalls(const LocalHole& hole, const HoldOut& chosen, const GroundTrend& trend);

// Of the vertices of a hole. What stands on the ground is a reading, and the ground under an object where it is known.
// New vertices of known height are fixed, and objects that the surface meets.
std::vector<RimReading> ReadingsOf(const LocalHole& hole);

// The same where the surface of the whole cluster is known: vertices of which it tells the height are fixed. Not known
// are those beyond the grid line, where tiles overlap, and those that two clusters share.
std::vector<RimReading> SettledReadingsOf(const LocalHole& hole);

// Heights of the surface with the fewest walls. Beside objects much of a rim stands above the ground, as feet of walls,
// kerbs, cars and bushes that the ground filter does not tell from it. A hole may also reach from the street down to a
// canal, or up to a roof. So the surface minimises, over the patch and along its edge,
//
//   integral of phi(|gradient - trend.slope|)  +  integral along the edge of rho(reading - height)
//
// where phi(s) is s^2 / (2 k) up to the steepness k of the ground, and s - k / 2 beyond: a wall costs its own area
// (total variation with Huber's function). rho counts a quarter of what stands above the surface, and twice what lies
// below it (as in quantile regression: Koenker and Bassett 1978). So a reading lifts the surface with a quarter of the
// slope k at most. One that lies low is followed, even if that takes a wall. Walls stand where they are shortest.
//
// Solved by lagged weights (Vogel and Oman 1996): a membrane each round, at most 20 rounds, until no height moves by
// more than 2 mm. The heights of all points of the patch are known then, and no point has an equation or a band. A
// patch cut along a line of known heights has nearly the same surface on both sides. False, with the heights as they
// were, if a system cannot be factorised, nothing is known of any height, or the problem is cancelled.
//   readings  of the first points of the problem
bool SolveWalledGround(const std::vector<RimReading>& readings, const GroundTrend& trend, ThinPlateProblem& problem);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SURFACE_WALLED_GROUND_H_
