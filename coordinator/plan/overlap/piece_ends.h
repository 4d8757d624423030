// Inside a tile of overlapping pieces: which chain goes on where one ends at the outline of a piece.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/records/survey_record.h"

namespace tilemend {

// Where the boundary of all pieces together, seen from above, passes from one edge to another.
struct EdgeCrossing {
  int32_t arriving = 0, leaving = 0;  // into SurveyRecord::edges: it comes along the one and goes on along the other
  Point2 place{0, 0};
};

struct PieceBoundary {
  const SurveyRecord& record;
  std::vector<bool> in_chain;    // of each edge: it is in a chain that bounds a hole, and on no outline
  std::vector<bool> on_outline;  // of each vertex: it is on the tile's outline
  std::vector<EdgeCrossing> crossings;
};

// A vertex on a piece's outline.
struct PieceEnd {
  int32_t vertex = 0;
  bool begins = false;  // a chain begins there, else one ends
};

struct PieceMatches {
  std::vector<std::pair<size_t, size_t>> pairs;  // where a chain begins, and the one that ends before it
  std::vector<size_t> on_outline;                // those that have no other: they count to the tile's outline
};

// Gives every end its other one. Two chains go together if the boundary passes from one to the other near their ends:
// pieces overlap by less than `reach`, so a chain runs no farther under another piece. Of several crossings of a chain
// the one nearest to its end counts. Ends that are left over, as among walls and trees, go with the nearest others,
// nearest pairs first. Ends on the tile's outline go with such as are near alone, as where pieces and the tile end
// together. What is left counts to the outline. Cost O(n log n), for each crossing the edges between it and the ends,
// and for each end those around it that are no nearer to others.
PieceMatches MatchPieceEnds(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
