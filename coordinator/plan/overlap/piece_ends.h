// Inside a tile of overlapping pieces: which chain goes on where one ends at the outline of a piece.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/records/survey_record.h"

namespace tilemend {

// A place on an edge of a chain.
struct ChainPlace {
  int32_t edge = 0;  // into SurveyRecord::edges
  Point2 place{0, 0};
};

// Where the boundary of all pieces together, seen from above, passes from one chain to another: at once where they
// cross, or along outlines of pieces; or so from a chain to the outline of the tile, or from there to a chain.
struct ChainPassage {
  std::optional<ChainPlace> arriving, leaving;  // it comes along the one and goes on along the other
  std::optional<Point2> at_outline;             // of the tile: one of both is none
};

struct PieceBoundary {
  const SurveyRecord& record;
  std::vector<bool> in_chain;    // of each edge: it is in a chain that bounds a hole, and on no outline
  std::vector<bool> on_outline;  // of each vertex: it is on the tile's outline
  std::vector<ChainPassage> passages;
};

// A vertex on a piece's outline.
struct PieceEnd {
  int32_t vertex = 0;
  bool begins = false;  // a chain begins there, else one ends
};

struct PieceMatches {
  std::vector<std::pair<size_t, size_t>> pairs;  // where a chain begins, and the one that ends before it
  // Those that have no other count to the tile's outline: where the way from them comes to it, if that is told.
  std::vector<std::pair<size_t, std::optional<Point2>>> on_outline;
};

// Gives every end its other one. Two chains go together if the boundary passes from one to the other near their ends:
// pieces overlap by less than `reach`, so a chain runs no farther under another piece. Of several passages of a chain
// the one nearest to its end counts. Ends near by that are left over, as among walls and trees, go with the nearest
// others, nearest pairs first. Then ends whose passage leads to the tile's outline count to it, and the rest go with
// the nearest at any distance. Ends on the tile's outline go with such as are near alone, as where pieces and the tile
// end together. What is left counts to the outline where it is. Cost O(n log n), for each passage the edges between it
// and the ends, and for each end those around it that are no nearer to others.
PieceMatches MatchPieceEnds(const PieceBoundary& boundary, const std::vector<PieceEnd>& ends, double reach);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_ENDS_H_
