// Holes of a single mesh that are probably its outline.
#ifndef TILEMEND_COORDINATOR_REPORT_OUTLINE_HOLES_H_
#define TILEMEND_COORDINATOR_REPORT_OUTLINE_HOLES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The holes whose boundary reaches as far as the whole mesh along two axes or three, but for a thousandth of its size.
// `low` and `high`: the corners of the mesh's box. A tile of a scene may have one, its outline; a pipe has one at each
// end. O(boundaries).
std::vector<int32_t> OutlineHoles(const Plan& plan, const Point3& low, const Point3& high);

// A line for each: that it is probably the outline, and how it is left open. "" if there is none.
std::string OutlineHolesText(const Plan& plan, const std::vector<int32_t>& holes);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_OUTLINE_HOLES_H_
