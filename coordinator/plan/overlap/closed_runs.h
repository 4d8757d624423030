// Runs of a tile's surface along its outline that a gap closes for themselves.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_

#include <span>
#include <vector>

#include "coordinator/plan/overlap/outline_walk.h"

namespace tilemend {

// A run is surface that goes on along the outline from the end of one gap to the beginning of the next. Gaps are
// matched by their places alone. So below an overhang, where a run goes backward, a gap may close it for itself, and a
// wall goes from the edge of the overhang to the street. Such a gap exchanges ends with one that has an end beside its
// own, if both together become shorter: along the outline, and up and down. Of the two the longer one along the outline
// is the street. It is measured straight, and down to the lowest of the four ends; it suffices that one of both is
// shorter. Gaps with ends off the outline stay.
//   on_outline  of each edge of the record
//   gaps        along the outline; what exchanges ends has begin, end and open set anew
// Cost O(n log n) in the gaps, and the record.
void JoinClosedRuns(const SurveyRecord& record, const std::vector<bool>& on_outline, const Outline& outline,
                    std::span<OutlineGap> gaps);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_CLOSED_RUNS_H_
