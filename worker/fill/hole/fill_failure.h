// Why a way to fill a hole leads to no patch.
#ifndef TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_
#define TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_

#include <string>

namespace tilemend {

enum class FillFailure {
  kNone,
  kNotApplicable,  // no way for this hole; never the reason why one stays open
  kNoArea,
  kUnknownHeights,
  kCrossesSeenFromAbove,
  kCrossesOnItsPlane,
  kRepeatsEdges,
  kNoSolution,
  kTurnsOver,
  kTooLongForSpace,
  kNoBridge,
  kCrosses,       // of all ways
  kPatchCrosses,  // of the one that was asked for
  kRimIsCrossed,  // and with that any patch is
  kFlatTriangle,
  kRepeatsTriangle,
  kOverfullEdge,
  kNotClosed,
  kFrontOpen,
  kTooLongForArea,
  kFoldsBack,
  kTooLongForFront,
  kTooMuchWork,
  kGoesFar,
  kTooLarge,
};

// For people.
//   boundary_edges  of the hole
std::string TextOf(FillFailure failure, size_t boundary_edges);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_
