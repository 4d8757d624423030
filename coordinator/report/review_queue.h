// The fills in the order in which a reviewer should look at them.
#ifndef TILEMEND_COORDINATOR_REPORT_REVIEW_QUEUE_H_
#define TILEMEND_COORDINATOR_REPORT_REVIEW_QUEUE_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "coordinator/report/scene_report.h"

namespace tilemend {

// The holes that one HoleEvidence is about.
struct ReviewedGroup {
  std::vector<int32_t> holes;  // in cells that were chosen; ascending
  int32_t largest = -1;        // of these
  double area = 0;             // m2
  double rim = 0;              // metres of original boundary
  double doubt = 0;            // metres
  int64_t crossings = 0;       // triangles of their patches that cross others (HolePatch::crossings)
};

// By evidence. The doubt is the height error that is to be expected (docs/decisions/2026-11-27-review.md):
//
//   (1 - p) e + p D     p  chance that the verdict is wrong      D  how far ground and water are apart
//                       e  error if it is right: of what is flat the standard deviation of its level, times the rim of
//                          a circle of that area over its own rim where that is shorter; of ground the error of
//                          predicting stretches of the rim that were held out, where that was done
// It is 0 where the user decided. Cost O(holes).
std::vector<ReviewedGroup> ReviewedGroups(const SceneReportInput& input);

// "accept", "water", "ground" or "open".
const char* DecisionName(ReviewDecision decision);
// That of the decision on the hole; nullptr if there is none.
const char* DecisionOn(const Plan& plan, int32_t hole);

// A row for each group with a doubt, by doubt x area, the largest first. It has "hole" (its largest), "holes", "cell"
// and "centre" of that, "area_m2" of all. Then what it was taken for and why (HoleEvidenceJson), "doubt_m" and
// "doubt_m3", and "crossings" if there are any.
nlohmann::ordered_json ReviewJson(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_REVIEW_QUEUE_H_
