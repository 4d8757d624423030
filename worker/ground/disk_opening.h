// Morphological opening of a raster with disks.
#ifndef TILEMEND_WORKER_GROUND_DISK_OPENING_H_
#define TILEMEND_WORKER_GROUND_DISK_OPENING_H_

#include <cstdint>
#include <vector>

#include "worker/ground/square_blocks.h"

namespace tilemend {

// Heights in whole steps, row by row.
struct StepRaster {
  int32_t cols = 0, rows = 0;
  std::vector<int16_t> heights;
};

// Squares without surface.
inline constexpr int16_t kNoSurface = INT16_MAX;

// The raster opened with a disk of `radius` squares: the lowest of each disk, then the highest of these over each disk.
// Squares without surface take no part: they lower nothing and lift nothing, and have the opening's value as well. What
// no disk with surface reaches stays kNoSurface. Nowhere above the raster. Depends on what is within 2 * radius squares
// alone.
//
// Rows are first reduced to minima of 1, 2, 4, ... squares. So each row of the disk takes two of them (Urbach and
// Wilkinson 2008). Cost O(radius) a square. Precondition: radius >= 0, and heights are at most INT16_MAX in size.
StepRaster OpenedByDisk(const StepRaster& raster, int32_t radius);

// The same in the squares of `asked`, a set for this raster. What other squares have has no meaning.
StepRaster OpenedByDisk(const StepRaster& raster, int32_t radius, const SquareBlocks& asked);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_DISK_OPENING_H_
