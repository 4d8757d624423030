// The one length below which two places are taken for one.
#ifndef TILEMEND_COORDINATOR_PLAN_TYPES_MEET_TOLERANCE_H_
#define TILEMEND_COORDINATOR_PLAN_TYPES_MEET_TOLERANCE_H_

namespace tilemend {

// Metres. Outlines of tiles that agree to this are straight, edges that come so near meet, borders that are no further
// apart do not overlap. Exports of photogrammetry round to a millimetre or two.
inline constexpr double kMeetTolerance = 2e-3;

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_TYPES_MEET_TOLERANCE_H_
