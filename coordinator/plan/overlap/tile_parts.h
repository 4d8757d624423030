// Tiles that are stored as several overlapping pieces, taken apart.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_PARTS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_PARTS_H_

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// The scene in parts: the leaves of an octree that a tile is stored as, else the tile. Part (c, r) of cell (C, R) is
// cell (C * columns + c, R * rows + r) of `input`.
struct TileParts {
  PlanInput input;  // a part without surface has no record; valid as long as the scene and this are
  GridLines own;    // the outlines of the parts
  std::map<std::pair<CellId, int>, double>
      line;                                // by part and side: the grid line, or the middle of two pieces' overlap
  int32_t columns = 1, rows = 1;           // parts of a cell
  std::map<CellId, SurveyRecord> records;  // of parts, without bands; none where tiles are whole
  std::map<CellId, std::vector<int32_t>>
      vertex_of;  // per such part: of each of its vertices, that of the tile's record

  bool whole() const { return columns * rows == 1; }
  CellId TileOf(CellId part) const;
};

// Pieces are told by straight outlines inside tiles: where one ends, another begins a little before. Such lines are
// looked for at the same place in all cells. Every connected piece of surface goes to the parts that it reaches into
// by more than that overlap.
//   own  the outlines of the tiles
// Cost O(n log n) in the boundary edges.
TileParts SplitTiles(const PlanInput& input, const GridLines& own, double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_TILE_PARTS_H_
