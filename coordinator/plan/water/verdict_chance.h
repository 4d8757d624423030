// How likely a verdict on a hole is wrong.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_CHANCE_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_CHANCE_H_

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/level_evidence.h"

namespace tilemend {

// The chance, 0 to 0.5, that `verdict` on a rim with this evidence is wrong (docs/decisions/2026-11-27-review.md). With
// J for the disagreement of the rim and D for the difference of a dry surface, water weighs (D / 2)^2 and ground J^2:
// the chance of the other is its weight over the sum of both. Rims that are too short to test have 0.5.
double ChanceOfError(HoleEvidence::Verdict verdict, const LevelEvidence& evidence);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_CHANCE_H_
