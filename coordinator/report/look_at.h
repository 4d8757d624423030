// The fills that a person should look at before the result is delivered.
#ifndef TILEMEND_COORDINATOR_REPORT_LOOK_AT_H_
#define TILEMEND_COORDINATOR_REPORT_LOOK_AT_H_

#include <nlohmann/json.hpp>

#include "coordinator/report/scene_report.h"

namespace tilemend {

// One row for each judged cluster or closed hole (HoleEvidence), the largest first.
// It has "hole" (its largest), "cell" and "centre" of that, "holes" (all by number), "area_m2" of all to 0.1 m2, and
// "taken_for". It has "level_m" and "sigma_m" if there is a level. Its "why" says which of these are true; there is no
// row if none is:
//   - it is filled flat, and sigma is more than 0.25 m: also where an area of the user says that it is water, but not
//     at which level;
//   - it is filled flat, at a level that its own rim tells, and that rim is shorter than a circle of its area: most of
//     it ends at the edge of the area;
//   - it has 1,000 m2 or more (the lakes of the profile `city`), and is filled as ground or level ground.
// The other two are asked only where no area decides. Holes that are left open are not among them: they are in `left`.
// Cost O(holes).
nlohmann::ordered_json LookAtJson(const SceneReportInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_LOOK_AT_H_
