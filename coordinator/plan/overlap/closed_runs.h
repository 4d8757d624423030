// Runs of a tile's surface along its outline that a gap closes for themselves.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_

#include <span>
#include <vector>

#include "coordinator/plan/overlap/outline_walk.h"

namespace tilemend {

// A run is surface that goes on along the outline from the end of one gap to the beginning of the next. Gaps are
// matched by their places alone, and exchange ends with one that has an end beside their own:
//   - below an overhang, where a run goes backward, a gap may close it for itself, and a wall goes from the edge of the
//     overhang to the street. Both exchange ends if together they become shorter: along the outline, and up and down.
//     Of the two the longer one along the outline is the street. It is measured straight, and down to the lowest of the
//     four ends; it suffices that one of both is shorter
//   - where one gap lies in another, as where a rest of the ground is left below a tree, the two may cross in the plane
//     of the outline. They exchange ends if both measures are shorter
// A gap that still closes a run for itself follows the run, if that counts less than the straight way (kOutlineWeight).
// Gaps with ends off the outline stay.
//   on_outline  of each edge of the record
//   gaps        along the outline; what exchanges ends has begin, end and open set anew; what follows a run
//               has it in OutlineGap::along, and no link is left
// Cost O(n log n) in the gaps, and the record; for each run that goes round without a gap once more.
void JoinClosedRuns(const SurveyRecord& record, const std::vector<bool>& on_outline, const Outline& outline,
                    std::span<OutlineGap> gaps);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_
