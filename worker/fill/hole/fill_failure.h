// Why a way to fill a hole leads to no patch.
#ifndef TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_
#define TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_

#include <cstddef>
#include <cstdint>
#include <string>

#include "common/mesh/mesh_limits.h"

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

// What the text of a failure tells of the hole and of its fill.
struct FailedHole {
  size_t boundary_edges = 0;
  int64_t max_vertices = kMaxResultPoints;  // the limit of the fill (FillHoles)
  bool is_in_scene = true;                  // else in a single mesh, which has no cells
};

// For people.
std::string TextOf(FillFailure failure, const FailedHole& hole);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_FILL_FAILURE_H_
