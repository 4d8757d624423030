// Inside a tile of overlapping pieces: which chain goes on where one ends at the outline of a piece.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/records/survey_record.h"
#include "coordinator/plan/overlap/piece_walk.h"

namespace tilemend {

// A vertex on a piece's outline.
struct PieceEnd {
  int32_t vertex = 0;
  bool begins = false;  // a chain begins there, else one ends
};

struct PieceMatches {
  std::vector<std::pair<size_t, size_t>> pairs;        // where a chain begins, and the one that ends before it
  std::vector<std::pair<size_t, int32_t>> on_outline;  // those that have no other, and the vertex where they come to it
};

// Gives every end its other one, or the place on the tile's outline that it counts to. First along the boundary of what
// the pieces cover together (PieceWalk). If that way is lost, as among walls and trees, it is the nearest end that is
// left, nearest pairs first. Ends near by are matched first. Then ends whose way leads to the outline count to it. Then
// the rest are matched at any distance. Ends on the tile's outline go with such as are near alone, as where pieces that
// overlap by `reach` and the tile end together. What is left counts to the outline where it is. Cost O(n log n), and
// for each end those around it that are no nearer to others.
PieceMatches MatchPieceEnds(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
