// Fills a hole, or a part of one, over a plane.
#ifndef TILEMEND_WORKER_FILL_PLANE_PLANE_FILL_H_
#define TILEMEND_WORKER_FILL_PLANE_PLANE_FILL_H_

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/plane/plane_heights.h"

namespace tilemend {

struct PlaneFillOptions {
  RimUse use = RimUse::kWhole;
  bool at_folds = false;  // the hole is what is left beside folds (folded_fill.h): the surface may join it by edges
};

// Triangulates the hole over the plane of `frame`, refines it and finds the heights of the new points
// (plane_heights.h). Then improves the shapes that triangles have in space (flip_edges.h, smooth_on_surface.h; for
// water only by turning edges). Wang's surface, but for water, has steps of its own: wang_fill.h.
//
// New points lie on the scene's lattice; over the upright plane also where the tile's number type holds them.
// Failures: the boundary crosses itself on the plane, the surface joins it by edges already, or the heights have no
// solution. Cost as RefineRegion and SolveThinPlate.
LocalPatch FillOverPlane(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                         const PlaneFillOptions& plane_options);

// The same as a part, over the first plane that fits. Planes tried are the one that the surface around the hole faces,
// the hole's own, and the one that all surroundings face most nearly. Not applicable if none does.
LocalPatch FillOverFacingPlane(const LocalHole& hole, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PLANE_PLANE_FILL_H_
