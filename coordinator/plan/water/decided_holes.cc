#include "coordinator/plan/water/decided_holes.h"

#include <algorithm>

#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/plan/water/area_index.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

bool IsDecision(const WaterArea& area) { return area.decision != ReviewDecision::kNone; }

}  // namespace

void DecideHoles(const std::vector<WaterArea>& areas, Plan& plan, const std::function<bool()>& is_cancelled) {
  if (std::ranges::none_of(areas, IsDecision)) return;
  const AreaIndex index(areas, is_cancelled);
  for (const std::vector<int32_t>& holes : GroupAllHoles(plan)) {
    if (index.cancelled()) return;
    const CoverLines region(BoundaryOf(plan, holes));
    const auto deciding = index.DeciderOf(region, index.SharesOf(region, IsDecision));
    if (!deciding) continue;
    for (const int32_t h : holes) {
      PlannedHole& hole = plan.holes[h];
      plan.decisions[h] = static_cast<int32_t>(deciding->area);
      const bool is_open = areas[deciding->area].decision == ReviewDecision::kOpen;
      if (is_open && hole.failure.empty()) hole.failure = kLeftByDecision;
    }
  }
}

}  // namespace tilemend
