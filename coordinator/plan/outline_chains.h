// Holes at the outline of a tile that ends where it likes: cut into chains that are closed one by one.
#ifndef TILEMEND_COORDINATOR_PLAN_OUTLINE_CHAINS_H_
#define TILEMEND_COORDINATOR_PLAN_OUTLINE_CHAINS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/cut_lines.h"
#include "coordinator/plan/plan.h"
#include "coordinator/plan/rim.h"
#include "coordinator/plan/rim_index.h"

namespace tilemend {

// For each rim edge the distance to another piece of the tile that ends along it, or -1: an edge in a plane of constant
// x, y or z, with an edge in a plane of the same kind that runs the other way within `reach` metres, shares no vertex
// with it, and is of another loop or lies over the surface (else the two are the sides of a crack). Photogrammetry
// stores a tile in boxes of an octree whose borders overlap a little and do not weld; such an outline is no hole.
std::vector<double> FindPieceBorders(const Rim& rim, const RimIndex& index, double reach);

struct OutlineChains {
  std::vector<std::vector<RimSegment>> loops;  // each a chain and the straight segment that closes it, hole on the left
  std::vector<LeftOpen> left;
  int64_t open_edges = 0;  // of runs that could not be closed
};

// Takes a loop of a tile apart that runs along the tile's outline (RimEdge::label is another cell) or along other
// pieces of the tile (`piece_border` >= 0). Every run of other edges between two such is closed by a straight segment
// between its ends if both lie on one side of the outline or in one plane of constant x, y or z; that segment stays
// open like the outline that it is a part of.
OutlineChains CloseChains(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
                          const std::vector<double>& piece_border);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OUTLINE_CHAINS_H_
