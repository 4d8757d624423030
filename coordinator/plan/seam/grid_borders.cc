#include "coordinator/plan/seam/grid_borders.h"

namespace tilemend {

double LineOf(const Border& border, const std::set<CellId>& area, const GridLines& lines) {
  const bool vertical = IsVertical(border);
  if (area.contains(border.first)) return lines.At(border.first, vertical ? kEast : kNorth);
  return lines.At(border.second, vertical ? kWest : kSouth);
}

Point2 CornerPosition(Corner c, const std::set<CellId>& area, const GridLines& lines) {
  const CellId west{c.col - 1, c.row}, south{c.col, c.row - 1}, south_west{c.col - 1, c.row - 1};
  // By the border north or east of the corner, unless that has no cell in the area.
  const auto line = [&](const Border& preferred, const Border& other) {
    const bool known = area.contains(preferred.first) || area.contains(preferred.second);
    return LineOf(known ? preferred : other, area, lines);
  };
  return {line({west, c}, {south_west, south}), line({south, c}, {south_west, west})};
}

double OverlapAt(Corner c, int axis, const GridLines& lines) {
  double overlap = 0;
  for (const CellId cell : CellsAround(c)) {
    const auto outline = lines.outline.find(cell);
    if (outline == lines.outline.end()) continue;
    const bool before = axis == 0 ? cell.col < c.col : cell.row < c.row;
    const Side side = axis == 0 ? (before ? kEast : kWest) : (before ? kNorth : kSouth);
    overlap = std::max(overlap, (outline->second[side] - lines.At(cell, side)) * OutwardOf(side));
  }
  return overlap;
}

bool TouchesOutside(Corner c, const std::set<CellId>& area) {
  const auto around = CellsAround(c);
  return !std::all_of(around.begin(), around.end(), [&](CellId cell) { return area.contains(cell); });
}

}  // namespace tilemend
