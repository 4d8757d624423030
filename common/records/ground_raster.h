// The lowest surface of a tile in the squares of a raster.
#ifndef TILEMEND_COMMON_RECORDS_GROUND_RASTER_H_
#define TILEMEND_COMMON_RECORDS_GROUND_RASTER_H_

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tilemend {

// The squares of all rasters of a scene lie on one lattice: square (0, 0) has its low corner at the scene's origin.
struct GroundRaster {
  double square = 1;           // metres: side of a square
  int32_t col = 0, row = 0;    // of the first square, on the lattice
  int32_t cols = 0, rows = 0;  // 0: no surface
  std::vector<float> heights;  // metres; row by row, the lowest y first; NaN: no surface in this square

  bool empty() const { return heights.empty(); }
  size_t IndexOf(int32_t lattice_col, int32_t lattice_row) const {
    return static_cast<size_t>(lattice_row - row) * cols + (lattice_col - col);
  }
  bool Contains(int32_t lattice_col, int32_t lattice_row) const {
    return lattice_col >= col && lattice_col < col + cols && lattice_row >= row && lattice_row < row + rows;
  }
};

// A raster without surface over the given squares.
inline GroundRaster EmptyRaster(double square, int32_t col, int32_t row, int32_t cols, int32_t rows) {
  return {square, col,  row,
          cols,   rows, std::vector<float>(static_cast<size_t>(cols) * rows, std::numeric_limits<float>::quiet_NaN())};
}

// The number of the square, along one axis, that a coordinate lies in.
inline int32_t SquareAt(double coordinate, double square) {
  const double squares = coordinate / square;
  const auto whole = static_cast<int32_t>(squares);
  return whole - (whole > squares ? 1 : 0);  // as std::floor, which is a call without SSE4.1
}

// What is ground at a place is told by the surface within this distance, metres: FilterReach of the default options
// (worker/ground/ground_filter.h).
inline constexpr double kGroundReach = 120;

// The side of the squares, metres: 1, or the power of two that leaves at most 1024 of them along a cell. So a raster
// has at most about a million squares, whatever the units of a scene.
inline double RasterSquareFor(double cell_width, double cell_height) {
  constexpr double kMostSquares = 1024;
  double square = 1;
  while (std::max(cell_width, cell_height) / square > kMostSquares) square *= 2;
  return square;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_GROUND_RASTER_H_
