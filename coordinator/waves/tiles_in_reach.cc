#include "coordinator/waves/tiles_in_reach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace tilemend {

std::set<CellId> TilesInReach(const CellHoles& cell, const Plan& plan, const PlanInput& input) {
  std::vector<Eigen::AlignedBox3d> reaches;
  for (const CellHole& hole : cell.holes) {
    if (!hole.open && !hole.level) reaches.push_back(ReachOf(cell, hole));
  }
  if (reaches.empty()) return {};
  std::set<CellId> candidates = {cell.cell}, tiles;
  for (const BorderAudit& border : plan.borders) {
    if (border.kind != BorderKind::kExact) continue;
    if (border.a == cell.cell) candidates.insert(border.b);
    if (border.b == cell.cell) candidates.insert(border.a);
  }
  for (const CellId candidate : candidates) {
    const auto tile = input.cells.find(candidate);
    if (tile == input.cells.end() || tile->second == nullptr) continue;
    const Eigen::AlignedBox3d extent(tile->second->lo, tile->second->hi);
    if (std::any_of(reaches.begin(), reaches.end(), [&](const auto& reach) { return reach.intersects(extent); })) {
      tiles.insert(candidate);
    }
  }
  return tiles;
}

}  // namespace tilemend
