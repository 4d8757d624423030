// Inside a tile of overlapping pieces: where the boundary of what they cover together goes on from the end of a chain.
#ifndef TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_WALK_H_
#define TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_WALK_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/records/survey_record.h"

namespace tilemend {

// A boundary edge of a tile is on the tile's outline, on that of a piece, or in a chain that bounds a hole. Surface is
// to the left of each.
enum class BoundaryKind : int8_t { kOutline, kPiece, kChain };

struct PieceBoundary {
  const SurveyRecord& record;       // has edges
  std::vector<BoundaryKind> kinds;  // of each edge
  std::vector<bool> on_outline;     // of each vertex: whether it is on the tile's outline
};

class PieceWalk {
 public:
  // Where a walk ends.
  struct Arrival {
    int32_t vertex = 0;
    bool on_outline = false;  // of the tile; else the next chain begins there
  };

  // The boundary must outlive this. A chain that ends at a piece's outline lies under another piece for `reach` metres
  // at most before it does. Cost linear.
  PieceWalk(const PieceBoundary& boundary, double reach);
  ~PieceWalk();

  // The boundary of the union of all pieces seen from above, from the chain that ends at vertex `end` on. It runs along
  // the outline of the piece that covers the end of the chain, or of its own piece if none does. Where it meets another
  // piece, it goes on along the outline of that. It ends where a chain leaves the outline that it runs along. With
  // `backward` it goes against the direction of the edges, from where a chain begins to where the one before ends.
  // Empty: the way is lost. Cost: the edges near the way.
  std::optional<Arrival> From(int32_t end, bool backward) const;

 private:
  class Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_OVERLAP_PIECE_WALK_H_
