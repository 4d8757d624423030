#include "coordinator/plan/water/decided_holes.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

bool IsDecision(const WaterArea& area) { return area.decision != ReviewDecision::kNone; }

// A cluster of open holes, or a closed hole, its boundary seen from above, and what the areas cover of it.
struct CoveredGroup {
  std::vector<int32_t> holes;
  bool hangs;
  std::vector<PlaneSegment> boundary;
  CoverLines region;
  std::vector<AreaShare> shares;
};

std::vector<CoveredGroup> CoveredGroups(const AreaIndex& index, const Plan& plan) {
  std::vector<CoveredGroup> groups;
  for (std::vector<int32_t>& holes : GroupAllHoles(plan)) {
    if (index.cancelled()) return {};
    std::vector<PlaneSegment> boundary = BoundaryOf(plan, holes);
    CoverLines region(boundary);
    std::vector<AreaShare> shares = index.SharesOf(region, IsDecision);
    if (shares.empty()) continue;
    const bool hangs = plan.holes[holes.front()].standing == Standing::kHanging;
    groups.push_back({std::move(holes), hangs, std::move(boundary), std::move(region), std::move(shares)});
  }
  return groups;
}

// Leaves areas out of groups that they are not about. An area about none is about those that do not hang over others.
void DropOthers(const std::vector<WaterArea>& areas, const AreaIndex& index, std::vector<CoveredGroup>& groups) {
  struct Most {
    double fit = 0;  // share of the area times share of the group
    const CoveredGroup* group = nullptr;
  };
  std::vector<Most> most(areas.size());
  std::map<size_t, CoverLines> lines;  // of the areas
  for (const CoveredGroup& group : groups) {
    for (const AreaShare& s : group.shares) {
      if (index.cancelled()) return;
      if (!lines.contains(s.area)) lines.emplace(s.area, SegmentsOf(areas[s.area]));
      const double share = lines.at(s.area).ShareIn(group.boundary);
      const double fit = share * s.share;
      if (share > kDecidingShare && fit > most[s.area].fit) most[s.area] = {fit, &group};
    }
  }
  for (CoveredGroup& group : groups) {
    std::erase_if(group.shares, [&](const AreaShare& s) {
      const CoveredGroup* about = most[s.area].group;
      return about != &group && (about != nullptr || group.hangs);
    });
  }
}

// Whether a whole rim, of which `lowest` is known, stands higher than the surface that the area takes out, as on a
// bridge over cleared water.
bool LiesAbove(std::optional<double> lowest, const WaterArea& area) {
  if (!area.clear || !area.water || !area.level) return false;
  const double top = *area.level + area.clear_height;
  return lowest && *lowest > top;
}

// Of the original vertices on a rim; none: there are none.
std::optional<double> LowestOnRim(const Plan& plan, const std::vector<int32_t>& holes) {
  std::optional<double> lowest;
  for (const int32_t v : RimVerticesOf(plan, holes)) {
    const double z = plan.vertices[v].position.z();
    lowest = std::min(lowest.value_or(z), z);
  }
  return lowest;
}

}  // namespace

std::optional<size_t> DeciderOf(const Plan& plan, const std::vector<int32_t>& holes,
                                const std::vector<WaterArea>& areas, const AreaIndex& index) {
  if (areas.empty()) return std::nullopt;
  const auto decision = plan.decisions.find(holes.front());
  if (decision != plan.decisions.end() && areas[decision->second].decision != ReviewDecision::kAccept)
    return decision->second;
  if (plan.holes[holes.front()].standing == Standing::kHanging) return std::nullopt;
  const CoverLines region(BoundaryOf(plan, holes));
  const auto is_of_water = [](const WaterArea& area) { return area.decision == ReviewDecision::kNone; };
  std::vector<AreaShare> shares = index.SharesOf(region, is_of_water);
  if (shares.empty()) return std::nullopt;
  const std::optional<double> lowest = LowestOnRim(plan, holes);
  std::erase_if(shares, [&](const AreaShare& s) { return LiesAbove(lowest, areas[s.area]); });
  const auto deciding = index.DeciderOf(region, shares);
  return deciding ? std::optional<size_t>(deciding->area) : std::nullopt;
}

void DecideHoles(const std::vector<WaterArea>& areas, Plan& plan, const std::function<bool()>& is_cancelled) {
  if (std::ranges::none_of(areas, IsDecision)) return;
  const AreaIndex index(areas, is_cancelled);
  std::vector<CoveredGroup> groups = CoveredGroups(index, plan);
  DropOthers(areas, index, groups);
  for (const CoveredGroup& group : groups) {
    if (index.cancelled()) return;
    const auto deciding = index.DeciderOf(group.region, group.shares);
    if (!deciding) continue;
    for (const int32_t h : group.holes) {
      PlannedHole& hole = plan.holes[h];
      plan.decisions[h] = static_cast<int32_t>(deciding->area);
      const bool is_open = areas[deciding->area].decision == ReviewDecision::kOpen;
      if (is_open && hole.failure.empty()) hole.failure = kLeftByDecision;
    }
  }
}

}  // namespace tilemend
