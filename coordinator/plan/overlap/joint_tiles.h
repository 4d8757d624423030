// Tiles that overlap, or part, as one clipped scene: what the plan is made from where tiles share no vertices.
//
// Every tile's boundary is cut at the grid lines (clip_tile.h). Along a line both neighbours then have stretches with
// surface. Where both have, they meet; where one has, its end bounds the other's hole; where neither has, the hole goes
// on across. So cells, seams, clusters and layers are what they are on a clipped cut. No vertex of a tile moves and
// none is joined to another: only the plan's picture of the tiles is cut. What is outside an area's polygon counts as
// surface of every tile.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_TILES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_TILES_H_

#include <cstdint>
#include <map>
#include <vector>

#include "coordinator/plan/overlap/clip_tile.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct JointTiles {
  // What is cut: the tiles' boundaries, in an area those of the part inside (tile_in_area.h).
  std::map<CellId, StoredRecord::Pointer> own;
  // The clipped boundaries, without bands. A record's vertices are all those of `own`, in order, then new ones on
  // the grid lines. The new ones' `index` goes on from the tile's vertex count.
  std::map<CellId, SurveyRecord> records;
  // Per tile, for each of its new vertices: the edges of the tile's own record that pass there.
  std::map<CellId, std::vector<std::vector<int32_t>>> edges_through;
  std::map<CellId, std::vector<bool>> cut;    // as ClippedTile::cut
  std::map<CellId, std::vector<bool>> chain;  // of each edge of the tile's own record: cut, and on no piece's outline
  std::map<CellId, ClipSquare> squares;
  PlanInput input;  // the scene with these records and no area; valid as long as they are
  GridLines lines;  // the grid lines
};

//   own         the outlines of the tiles
//   area_rings  the area's edge (SpacedRings); null: all cells
// Cost O(n log n) in the boundary edges; in tiles that the area's edge crosses times those of its points that are
// there.
JointTiles JoinTiles(const PlanInput& input, const GridLines& own, double lattice_step,
                     const std::vector<std::vector<Point2>>* area_rings = nullptr);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_JOINT_TILES_H_
