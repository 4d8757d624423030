// Rims and grid lines made by hand, for tests of the planning's steps.
#ifndef TILEMEND_TESTS_SUPPORT_RIM_BUILDERS_H_
#define TILEMEND_TESTS_SUPPORT_RIM_BUILDERS_H_

#include <cstdint>
#include <set>
#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

using Loop3 = std::vector<Point3>;

// The rim of one tile: loops around holes are clockwise seen from above, those around surface counter-clockwise. Point
// and edge k of a loop have the same number; normals point up, sizes are the means of the edges' lengths.
inline Rim RimOf(const std::vector<Loop3>& loops, CellId tile = {}) {
  Rim rim;
  for (const Loop3& loop : loops) {
    const auto first = static_cast<int32_t>(rim.points.size()), n = static_cast<int32_t>(loop.size());
    rim.loops.emplace_back();
    for (int32_t i = 0; i < n; ++i) {
      const Point3 &before = loop[(i + n - 1) % n], &after = loop[(i + 1) % n];
      RimPoint p;
      p.tile = tile;
      p.index = first + i;
      p.position = loop[i];
      p.size = ((before - loop[i]).norm() + (after - loop[i]).norm()) / 2;
      p.reach = p.size;
      rim.points.push_back(p);
      rim.point_of[tile].push_back(first + i);
      rim.edges.push_back({first + i, first + (i + 1) % n, tile});
      rim.loops.back().push_back(first + i);
    }
  }
  return rim;
}

// The closing cells where every edge is closed by its owner.
inline ClosingCells OwnersOf(const Rim& rim) {
  ClosingCells closing;
  for (const RimEdge& e : rim.edges) closing.push_back(e.owner);
  return closing;
}

// Square cells of `side` metres, the south-west corner of cell (0, 0) at 0, 0; no tiles.
inline PlanInput CellsOf(const std::set<CellId>& area, double side) {
  PlanInput input;
  input.grid.cell_size = Point2(side, side);
  for (const CellId cell : area) input.cells[cell] = nullptr;
  return input;
}

// Their lines.
inline GridLines LinesOf(const std::set<CellId>& area, double side) {
  const PlanInput input = CellsOf(area, side);
  GridLines lines;
  for (const CellId cell : area) {
    for (const Side s : kSides) lines.coordinate[cell][s] = NominalLine(input.grid, cell, s);
  }
  return lines;
}

// The cells of `cols` columns and `rows` rows.
inline std::set<CellId> AreaOf(int32_t cols, int32_t rows) {
  std::set<CellId> area;
  for (int32_t col = 0; col < cols; ++col) {
    for (int32_t row = 0; row < rows; ++row) area.insert({col, row});
  }
  return area;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_RIM_BUILDERS_H_
