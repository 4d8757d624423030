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
    std::vector<double> shares(areas.size(), 0);
    for (size_t a = 0; a < areas.size(); ++a) {
      if (IsDecision(areas[a])) shares[a] = region.ShareIn(areas[a]);
    }
    const auto deciding = FindDecidingArea(region, shares, areas);
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
