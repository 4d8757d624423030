// Tiles that are stored as several overlapping pieces: where a piece ends and the next goes on.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_OUTLINES_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_OUTLINES_H_

#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/rim/piece_layout.h"

namespace tilemend {

// For each boundary edge of a tile: whether it is on the outline of a piece, beyond which another piece goes on. Such
// are no rims of holes. Pieces are leaves of an octree, of any sizes. Each ends at planes across the axes of the layout
// (upright ones and level ones), and the next begins at most `layout.reach` metres before. A plane is taken for an
// outline if one piece ends and another begins there along some length of boundary. Pieces that share vertices
// elsewhere count as one; their outlines are told by boundaries that run along each other. A tile in which surface lies
// above surface along less than half of all that, seen from above, has no pieces: what it has are narrow strips of
// surface. Cost O(n log n), and for each pair of such planes n and the product of their edges.
std::vector<bool> FindPieceOutlines(const SurveyRecord& record, const PieceLayout& layout);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_OUTLINES_H_
