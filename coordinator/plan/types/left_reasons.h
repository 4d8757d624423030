// Reasons why holes stay open that other code looks for. The others stand where they are found.
#ifndef TILEMEND_COORDINATOR_PLAN_TYPES_LEFT_REASONS_H_
#define TILEMEND_COORDINATOR_PLAN_TYPES_LEFT_REASONS_H_

namespace tilemend {

// The failure of a hole that nothing bounds at the rim of an area that is not known.
inline constexpr char kReachesUnknownRim[] =
    "it reaches the rim of the area, which is not known; --area FILE (inspect --propose-area FILE draws one) or "
    "area_known in a scene.json with all its cells fills it";

// Holes that nobody wants filled: they make no job partial.
inline constexpr char kLongerThanChosen[] = "longer than --largest-hole";
inline constexpr char kLeftByDecision[] = "left open by decision";

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_TYPES_LEFT_REASONS_H_
