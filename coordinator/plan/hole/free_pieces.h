// Pieces of surface that hang above a hole, as lanterns and crowns whose posts and trunks are missing.
#ifndef TILEMEND_COORDINATOR_PLAN_HOLE_FREE_PIECES_H_
#define TILEMEND_COORDINATOR_PLAN_HOLE_FREE_PIECES_H_

#include <cstdint>
#include <map>
#include <set>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// By tile, as BoundaryEdge::piece of its record.
using FreePieces = std::map<CellId, std::set<int32_t>>;

// A piece hangs free if each of its boundary vertices stands on an object, above ground that is known, and a wall down
// to that ground would have over ten times the area that closes its loops. (A round piece with one opening hangs higher
// than 2.5 times the width of that.) No other surface of its tile may be over or under its boundary, as far as eight of
// its vertices tell, and the outline of the tile must not cut it. Cost O(n log n) in the boundary edges, and for each
// such piece eight times that of the edges level with it.
FreePieces FindFreePieces(const PlanInput& input);

// The input without the boundary edges of the pieces, as if they were not there: the fill passes below them. Vertices
// keep their numbers. The records of the tiles are copied.
PlanInput WithoutPieces(PlanInput input, const FreePieces& pieces);

// Adds what the loops of the pieces bound as if nothing lay around them: holes in them, and outlines that stay open.
//   input  with the pieces
// Precondition: nothing remembers numbers of holes yet.
void AddFreePieces(const PlanInput& input, const FreePieces& pieces, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_FREE_PIECES_H_
