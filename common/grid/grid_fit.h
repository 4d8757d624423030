// The grid that a set of tiles was cut by, from their indices and bounds.
#ifndef TILEMEND_COMMON_GRID_GRID_FIT_H_
#define TILEMEND_COMMON_GRID_GRID_FIT_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// A tile may reach this share of a cell beyond its own: whole triangles on a ragged cut, overlap of neighbours.
inline constexpr double kReachBeyondCell = 0.25;

struct PlacedTile {
  CellId cell;
  std::string name;  // for messages
  Box bounds;
};

// Works out cell size and corner so that cell (c, r) holds tile (c, r). `tiles` is not empty.
//
// The pitch along an axis is the median of (difference of bounds) / (difference of index) over tiles near each other.
// It is taken from both low and high sides. So it does not shift if all tiles are grown by one overlap, cut along a
// zigzag, or shortened by a hole at their border. With one column (row) only, cells are taken as square if the tiles'
// own extent agrees, or if they lie at different places within a square; else the median extent is the cell size. The
// results are rounded to the coarsest decimal step that lies within the scatter of the tiles.
//
// kInvalidArgument, naming the tile, if a tile reaches too far beyond the cell that its index gives it, or if the
// indices run against the coordinates. Deterministic for any order of `tiles`. O(n log n).
absl::StatusOr<Grid> FitGrid(std::vector<PlacedTile> tiles);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_GRID_FIT_H_
