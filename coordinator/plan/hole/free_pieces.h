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

// A piece is free if all of this holds:
//   - Each of its boundary vertices stands on an object, above ground that is known.
//   - Its loops close. A wall from them to the ground would have over ten times the area of the triangles from their
//     edges to their middles: a round opening hangs higher than 2.5 times its width.
//   - It lies inside its cell and inside its tile's outline, by more than its longest edge, and in the area's polygon.
//   - The other pieces of its tile wind around none of its vertices, as far as eight of them tell: it is over a hole.
//     (What faces down counts against what faces up.)
// Single meshes have none, nor have tiles whose ground is not told. If a tile has so many pieces and edges that the
// last question takes too long, none of its pieces is free. Cost O(n log n) in the boundary edges beside that question.
FreePieces FindFreePieces(const PlanInput& input);

// The input without the boundary edges of the pieces, as if they were not there: the fill passes below them. Vertices
// keep their numbers.
PlanInput WithoutPieces(PlanInput input, const FreePieces& pieces);

// Adds what the loops of the pieces bound as if nothing lay around them: holes in them, and outlines that stay open.
//   input  with the pieces
// Precondition: nothing in the plan has numbers of holes yet (water, evidence, decisions, clusters).
void AddFreePieces(const PlanInput& input, const FreePieces& pieces, const PlanOptions& options, Plan& plan);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_HOLE_FREE_PIECES_H_
