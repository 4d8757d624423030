// Ground and objects at the boundary vertices of a tile, and the ground around its holes.
#ifndef TILEMEND_WORKER_GROUND_RIM_OBJECTS_H_
#define TILEMEND_WORKER_GROUND_RIM_OBJECTS_H_

#include <span>

#include "common/mesh/tri_mesh.h"
#include "common/records/ground_raster.h"
#include "common/records/rim_ground.h"
#include "worker/ground/ground_filter.h"

namespace tilemend {

// Which of the vertices stand on an object (a house, a tree, a wall), and not on the ground. They are those that are
// higher above the ground of their square, or lower below it, than its tolerance (FilteredGround). Those in whose
// square nothing is known of the ground also count. A vertex whose square has no surface stands on none. The ground is
// that of the square, where it has some or lies between squares that do.
//
// The ground around holes is told in squares of kSquaresAlongSide squares. Holes are squares without surface, in the
// extent of all rasters, at most two from a vertex.
//
//   rasters  of the tile and of all within FilterReach of the vertices, with squares of one size; where they
//            overlap the lowest counts
//
// The same for each vertex whatever others are asked for, and however the scene is cut into tiles. Cost of FilterGround
// over the vertices' extent grown by its reach. Pure.
RimGround GroundAtRim(std::span<const Point3> vertices, std::span<const GroundRaster> rasters,
                      const GroundFilterOptions& options = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_RIM_OBJECTS_H_
