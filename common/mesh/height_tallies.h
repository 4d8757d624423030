// How much surface lies at which height inside each of many polygons.
#ifndef TILEMEND_COMMON_MESH_HEIGHT_TALLIES_H_
#define TILEMEND_COMMON_MESH_HEIGHT_TALLIES_H_

#include <span>
#include <vector>

#include "common/mesh/height_tally.h"
#include "common/mesh/mesh_view.h"

namespace tilemend {

// TallyHeights of each polygon, in their order. A triangle is looked at in the polygons near it alone: cost O(log n) a
// triangle for n polygons, and O(sqrt(points)) for each polygon whose bounds its centroid lies in.
std::vector<HeightTally> TallyHeightsIn(const MeshView& mesh, std::span<const PlanePolygon> polygons);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_HEIGHT_TALLIES_H_
