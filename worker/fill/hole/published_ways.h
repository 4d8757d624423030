// The ways to fill that papers describe, as the ways of production see them.
#ifndef TILEMEND_WORKER_FILL_HOLE_PUBLISHED_WAYS_H_
#define TILEMEND_WORKER_FILL_HOLE_PUBLISHED_WAYS_H_

#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"

namespace tilemend {

struct FillOptions;

// The triangles of the surface around a hole.
using SurroundingTriangles = std::function<std::span<const SpaceTriangle>()>;

// worker/papers has the functions. Production calls them where options.surface or options.filler asks for one, and
// includes nothing of them.
struct PublishedWays {
  // Surface::kWang over a plane (worker/papers/wang/wang_fill.h, FillAsWang).
  LocalPatch (*over_plane)(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options,
                           bool may_repeat) = nullptr;
  // Surface::kWang in space, from triangles of the boundary on (ShapeAsWang there).
  LocalPatch (*in_space)(const LocalHole& hole, std::vector<Triangle> triangles, const FillOptions& options) = nullptr;
  // A closed hole by the filler that options.filler names.
  LocalPatch (*by_name)(const LocalHole& hole, const FillOptions& options,
                        const SurroundingTriangles& surface) = nullptr;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_PUBLISHED_WAYS_H_
