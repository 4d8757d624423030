// The heights of a patch over a plane.
#ifndef TILEMEND_WORKER_FILL_PLANE_PLANE_HEIGHTS_H_
#define TILEMEND_WORKER_FILL_PLANE_PLANE_HEIGHTS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/fill/hole/projection_frame.h"

namespace tilemend {

// What the rim of a hole says of the surface inside.
enum class RimUse {
  kWhole,  // the whole rim: chooses the tension, where that is open, and bounds the heights; no slope from walls
  kPart,   // a part of a hole, or one with folds: too little rim of its own to choose by
};

// A triangulated patch in the frame of its plane.
struct PlanePatch {
  std::vector<Point3> points;  // the hole's vertices, then the new ones
  std::vector<Triangle> triangles;
  std::vector<bool> has_equation;  // of the hole's vertices
};

// Fills in the heights (z) of the new points: the hole's level if it has one, else those of the thin plate. Rim
// vertices on objects get those at which the surface passes. False if they cannot be found.
//   chosen  the tension, where it was chosen for this patch
bool FindHeights(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, RimUse use,
                 PlanePatch& patch, std::optional<HoldOut>& chosen);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_PLANE_PLANE_HEIGHTS_H_
