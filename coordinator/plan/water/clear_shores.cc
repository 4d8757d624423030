#include "coordinator/plan/water/clear_shores.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "common/records/flat_water.h"
#include "coordinator/plan/water/area_index.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

constexpr double kIsCovered = 0.01;  // share of a cell, as that of squares that --area makes cells
constexpr char kNothingToFill[] = " took surface out of it, and no hole was found to fill; draw the polygon otherwise";

// Decisions of a reviewer change no shore.
bool IsCleared(const WaterBody& body, const std::vector<WaterArea>& areas, const AreaIndex& index, const Plan& plan) {
  const CoverLines region(BoundaryOf(plan, body.holes));
  const auto is_of_water = [](const WaterArea& area) { return area.decision == ReviewDecision::kNone; };
  const auto deciding = index.DeciderOf(region, index.SharesOf(region, is_of_water));
  return deciding && areas[deciding->area].clear;
}

void MarkShore(const WaterBody& body, Plan& plan) {
  ForRimAboveWater(body, plan, [](PlanVertex& vertex, double above) {
    if (std::abs(above) > kFlatWithin) vertex.on_object = true;
  });
}

CoverLines LinesOf(const Grid& grid, CellId cell) {
  const Point2 low = grid.corner + Point2(cell.col, cell.row).cwiseProduct(grid.cell_size);
  const Point2 high = low + grid.cell_size;
  const std::vector<Point2> corners = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  std::vector<PlaneSegment> sides;
  for (size_t k = 0; k < corners.size(); ++k) sides.emplace_back(corners[k], corners[(k + 1) % corners.size()]);
  return CoverLines(sides);
}

bool HasCleared(const WaterArea& area) { return !area.cleared_cells.empty(); }

using CellOfArea = std::pair<size_t, CellId>;

// The cells that areas took surface out of and cover some hole of.
std::set<CellOfArea> CellsWithHolesUnder(const std::vector<WaterArea>& areas, const AreaIndex& index,
                                         const Plan& plan) {
  std::set<CellId> cells;
  for (const WaterArea& area : areas) cells.insert(area.cleared_cells.begin(), area.cleared_cells.end());
  std::set<CellOfArea> found;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const CellId cell = plan.holes[h].cell;
    if (index.cancelled()) break;
    if (!cells.contains(cell)) continue;
    const CoverLines region(BoundaryOf(plan, {static_cast<int32_t>(h)}));
    for (const AreaShare& s : index.SharesOf(region, HasCleared)) found.emplace(s.area, cell);
  }
  return found;
}

}  // namespace

void LeaveClearedCells(const Grid& grid, const std::vector<WaterArea>& areas, Plan& plan,
                       const std::function<bool()>& is_cancelled) {
  if (std::ranges::none_of(areas, HasCleared)) return;
  const AreaIndex index(areas, is_cancelled);
  const std::set<CellOfArea> has_hole = CellsWithHolesUnder(areas, index, plan);
  for (size_t a = 0; a < areas.size(); ++a) {
    for (const CellId cell : areas[a].cleared_cells) {
      if (index.cancelled()) return;
      if (has_hole.contains({a, cell}) || LinesOf(grid, cell).ShareIn(areas[a]) <= kIsCovered) continue;
      plan.left.push_back({cell, areas[a].label + kNothingToFill});
    }
  }
}

void MarkClearedShores(const std::vector<WaterArea>& areas, Plan& plan, const std::function<bool()>& is_cancelled) {
  if (std::none_of(areas.begin(), areas.end(), [](const WaterArea& area) { return area.clear; })) return;
  const AreaIndex index(areas, is_cancelled);
  for (const WaterBody& body : plan.water) {
    if (index.cancelled()) return;
    if (IsCleared(body, areas, index, plan)) MarkShore(body, plan);
  }
}

}  // namespace tilemend
