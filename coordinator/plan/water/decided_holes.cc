#include "coordinator/plan/water/decided_holes.h"

#include <algorithm>
#include <cstddef>

#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

bool IsDecision(const WaterArea& area) { return area.decision != ReviewDecision::kNone; }

}  // namespace

void DecideHoles(const std::vector<WaterArea>& areas, Plan& plan) {
  if (std::ranges::none_of(areas, IsDecision)) return;
  for (const std::vector<int32_t>& holes : GroupAllHoles(plan)) {
    const CoverLines region(BoundaryOf(plan, holes));
    int32_t decision = -1;
    for (size_t a = 0; a < areas.size(); ++a) {
      if (IsDecision(areas[a]) && region.ShareIn(areas[a]) > kDecidingShare) decision = static_cast<int32_t>(a);
    }
    if (decision < 0) continue;
    for (const int32_t h : holes) {
      PlannedHole& hole = plan.holes[h];
      plan.decisions[h] = decision;
      if (areas[decision].decision == ReviewDecision::kOpen && hole.failure.empty()) hole.failure = kLeftByDecision;
    }
  }
}

}  // namespace tilemend
