// Why a hole was taken for water or not, in words.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_WORDS_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_WORDS_H_

#include <string>

#include "coordinator/plan/types/plan_types.h"
#include "coordinator/plan/water/basins.h"

namespace tilemend {

inline constexpr char kNotLookedFor[] = "water is not looked for";
inline constexpr char kNoRim[] = "no original surface bounds it, so no level is known";

// Of a hole that an area of the user decides on.
std::string DecidedBy(const WaterArea& area);

// What `verdict` on a basin follows from. `low_ground`: GroundAround::low.
std::string ReasonFor(HoleEvidence::Verdict verdict, const Basin& basin, double low_ground,
                      const WaterProfile& profile);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_VERDICT_WORDS_H_
