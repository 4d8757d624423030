// The squares of a raster that the openings of the ground filter take for objects.
#ifndef TILEMEND_WORKER_GROUND_OBJECT_SQUARES_H_
#define TILEMEND_WORKER_GROUND_OBJECT_SQUARES_H_

#include <cstdint>
#include <span>
#include <vector>

#include "worker/ground/disk_opening.h"
#include "worker/ground/square_blocks.h"

namespace tilemend {

struct OpeningStep {
  int32_t radius = 1;  // squares
  double most = 0;     // steps of height: where an opening is lower by more than the one before, there is an object
};

// Of each square of the raster, 1 or 0: whether an opening is lower there than the one before (the first: than the
// surface) by more than its `most`. Says so of squares of `asked` that have surface. What it says of others has no
// meaning.
//
// Large openings are made only around squares from which they can take so much. That is told by the lowest surface of a
// few boxes of blocks: each has a disk inside that covers the square, and no opening is lower than the lowest surface
// of such a disk. Cost: that of the small openings where the ground is open, at most twice that of all openings.
std::vector<uint8_t> ObjectSquares(const StepRaster& surface, const SquareBlocks& asked,
                                   std::span<const OpeningStep> steps);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_OBJECT_SQUARES_H_
