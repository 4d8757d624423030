#include "coordinator/waves/tiles_in_reach.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "coordinator/plan/types/cell_side.h"

namespace tilemend {
namespace {

// Whether two neighbours share vertices along their border. The borders are in order of their cells.
bool IsExact(const Plan& plan, CellId a, CellId b) {
  auto border = std::partition_point(plan.borders.begin(), plan.borders.end(),
                                     [&](const BorderAudit& audit) { return audit.a < a; });
  for (; border != plan.borders.end() && border->a == a; ++border) {
    if (border->b == b) return border->kind == BorderKind::kExact;
  }
  return false;
}

}  // namespace

std::set<CellId> TilesInReach(const CellHoles& cell, const Plan& plan, const PlanInput& input) {
  std::vector<Eigen::AlignedBox3d> reaches;
  for (const CellHole& hole : cell.holes) reaches.push_back(ReachOf(cell, hole));
  if (reaches.empty()) return {};
  std::set<CellId> candidates = {cell.cell}, tiles;
  for (const Side side : kSides) {
    const CellId other = Across(cell.cell, side);
    if (IsExact(plan, std::min(cell.cell, other), std::max(cell.cell, other))) candidates.insert(other);
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
