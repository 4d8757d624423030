// How much of each square of a grid an area covers.
#ifndef TILEMEND_COMMON_GRID_AREA_SHARES_H_
#define TILEMEND_COMMON_GRID_AREA_SHARES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/scene.h"

namespace tilemend {

// The squares [from, to) of a grid.
struct Squares {
  CellId from, to;
  int32_t cols() const { return to.col - from.col; }
  int32_t rows() const { return to.row - from.row; }
};

// The share of each of the squares that is inside the area, 0 to 1, row by row. Exact but for rounding if the rings do
// not cross. What lies beyond the squares is not counted. Cost O((points + rows) * (edges at one height + columns)).
std::vector<double> SharesOf(const PlanePolygon& area, const Grid& grid, const Squares& squares);

// How much of the area lies in `cells`, each of which is there once, in the unit of the grid squared. Cost as SharesOf
// for each rectangle of cells that the rows of `cells` make up.
double AreaInCells(const PlanePolygon& area, const Grid& grid, std::span<const CellId> cells);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_AREA_SHARES_H_
