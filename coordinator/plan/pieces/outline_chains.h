// Holes at the outline of a tile that ends where it likes: cut into chains that are closed one by one.
#ifndef TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_
#define TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// For each rim edge the distance to another piece of the tile that ends along it, or -1: an edge in a plane of constant
// x, y or z, with an edge in a plane of the same kind that runs the other way within `reach` metres, shares no vertex
// with it, and is of another loop or lies over the surface (else the two are the sides of a crack). Photogrammetry
// stores a tile in boxes of an octree whose borders overlap a little and do not weld; such an outline is no hole.
std::vector<double> FindPieceBorders(const Rim& rim, const RimIndex& index, double reach);

struct OutlineChains {
  std::vector<std::vector<RimSegment>> loops;  // each a chain and the straight segment that closes it, hole on the left
  std::vector<LeftOpen> left;
  std::vector<std::vector<int32_t>> open_runs;  // edges of the runs that cannot be closed on their own
};

// Takes a loop of a tile apart that runs along the tile's outline (RimEdge::label is another cell) or along other
// pieces of the tile (`piece_border` >= 0). Every run of other edges between two such is closed by a straight segment
// between its ends if both lie on one side of the outline or in one plane of constant x, y or z; that segment stays
// open like the outline that it is a part of. Other runs are open: see LinkRuns.
OutlineChains CloseChains(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
                          const std::vector<double>& piece_border);

// Joins open runs of one tile, of any of its loops, to loops by straight segments between ends on one side or in one
// plane, nearest ends first: a hole that crosses a piece from side to side has a run on either bank. Runs that stay
// over are left.
OutlineChains LinkRuns(const std::vector<std::vector<int32_t>>& runs, const Rim& rim, const CutLines& lines);

// The runs of edges of a loop, each of at most `longest` edges, that begin and end on the same side of the tile's
// outline, between edges with one label: what can be closed there without the rest of the loop.
std::vector<std::vector<int32_t>> OneSidedRuns(const std::vector<int32_t>& loop, const Rim& rim, const CutLines& lines,
                                               size_t longest);

// Whether a loop is the outline of a small detached piece: it runs the wrong way round for a hole.
bool IsDetachedOutline(const std::vector<int32_t>& loop, const Rim& rim, double largest);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_CHAINS_H_
