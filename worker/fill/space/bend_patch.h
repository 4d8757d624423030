// New points of a patch on the surface of least bending in space.
#ifndef TILEMEND_WORKER_FILL_SPACE_BEND_PATCH_H_
#define TILEMEND_WORKER_FILL_SPACE_BEND_PATCH_H_

#include <optional>
#include <span>
#include <vector>

#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// Where the new points of a patch lie on the surface of least bending that goes on from the band (fair_surface.h). No
// value if it cannot be found.
//   shape       of the hole's vertices and the new points: positions in which the triangles have the shapes to keep
//   new_points  where they are
//   triangles   over both
std::optional<std::vector<Point3>> BendPatch(const LocalHole& hole, std::vector<Point3> shape,
                                             std::span<const Point3> new_points,
                                             const std::vector<Triangle>& triangles);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_BEND_PATCH_H_
