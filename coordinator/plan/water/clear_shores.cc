#include "coordinator/plan/water/clear_shores.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "common/records/flat_water.h"
#include "coordinator/plan/water/area_cover.h"
#include "coordinator/plan/water/hole_groups.h"

namespace tilemend {
namespace {

constexpr double kIsCovered = 0.01;  // share of a cell, as that of squares that --area makes cells

// Decisions of a reviewer change no shore.
bool IsCleared(const WaterBody& body, const std::vector<WaterArea>& areas, const Plan& plan) {
  const CoverLines region(BoundaryOf(plan, body.holes));
  std::vector<double> shares;
  for (const WaterArea& area : areas) {
    shares.push_back(area.decision == ReviewDecision::kNone ? region.ShareIn(area) : 0);
  }
  const auto deciding = FindDecidingArea(region, shares, areas);
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

bool LiesOverHole(const WaterArea& area, const std::vector<int32_t>& holes, const Plan& plan) {
  return std::ranges::any_of(holes, [&](int32_t h) { return CoverLines(BoundaryOf(plan, {h})).ShareIn(area) > 0; });
}

}  // namespace

void LeaveClearedCells(const Grid& grid, const std::vector<WaterArea>& areas, Plan& plan) {
  if (std::ranges::all_of(areas, [](const WaterArea& area) { return area.cleared_cells.empty(); })) return;
  std::map<CellId, std::vector<int32_t>> holes_of;
  for (size_t h = 0; h < plan.holes.size(); ++h) holes_of[plan.holes[h].cell].push_back(static_cast<int32_t>(h));
  for (const WaterArea& area : areas) {
    for (const CellId cell : area.cleared_cells) {
      if (LinesOf(grid, cell).ShareIn(area) <= kIsCovered || LiesOverHole(area, holes_of[cell], plan)) continue;
      plan.left.push_back(
          {cell, area.label + " took surface out of it, and no hole was found to fill; draw the polygon otherwise"});
    }
  }
}

void MarkClearedShores(const std::vector<WaterArea>& areas, Plan& plan) {
  if (std::none_of(areas.begin(), areas.end(), [](const WaterArea& area) { return area.clear; })) return;
  for (const WaterBody& body : plan.water) {
    if (IsCleared(body, areas, plan)) MarkShore(body, plan);
  }
}

}  // namespace tilemend
