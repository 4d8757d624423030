// Rings as a GIS wants them.
#ifndef TILEMEND_COMMON_MESH_WINDING_SIMPLE_RINGS_H_
#define TILEMEND_COMMON_MESH_WINDING_SIMPLE_RINGS_H_

#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

enum class Wound {
  kLeft,    // what rings wind around counter-clockwise
  kEither,  // and clockwise
};

// The outline of the region that closed rings wind around; they may cross and fold over themselves. The result is rings
// with the region on their left that do not cross and touch in single points at most. So PolygonsOf
// (common/mesh/ring_polygons.h) makes valid polygons of them. In metres, rounded to millimetres (where the rings are
// larger than 268 km to a coarser step); empty if nothing as large is left. Rings do not repeat their first point. Cost
// as of FindWoundRegion.
std::vector<std::vector<Point2>> SimpleRings(const std::vector<std::vector<Point2>>& rings, Wound wound);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_WINDING_SIMPLE_RINGS_H_
