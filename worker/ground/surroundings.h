// The ground around holes.
#ifndef TILEMEND_WORKER_GROUND_SURROUNDINGS_H_
#define TILEMEND_WORKER_GROUND_SURROUNDINGS_H_

#include <cstdint>
#include <vector>

#include "common/records/ground_raster.h"
#include "common/records/rim_ground.h"
#include "worker/ground/ground_filter.h"
#include "worker/ground/square_blocks.h"

namespace tilemend {

// Squares of a raster along a side of a GroundSquare.
inline constexpr int32_t kSquaresAlongSide = 3;

// Whether a square of the lattice is at most two squares from one without surface, within the raster: the triangles of
// a ragged rim may cover the next one.
bool IsBesideHole(const GroundRaster& lowest, int32_t col, int32_t row);

// All that is within kSurroundingsReach of the squares in `rims`, and up to two blocks more.
SquareBlocks SurroundingsOf(const SquareBlocks& rims, double square);

// The ground in the squares of `near`, row by row.
std::vector<GroundSquare> GroundIn(const SquareBlocks& near, const GroundRaster& lowest,
                                   const FilteredGround& filtered);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_SURROUNDINGS_H_
