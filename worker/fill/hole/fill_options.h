// How holes are to be filled.
#ifndef TILEMEND_WORKER_FILL_HOLE_FILL_OPTIONS_H_
#define TILEMEND_WORKER_FILL_HOLE_FILL_OPTIONS_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/filler.h"
#include "common/records/surface.h"
#include "worker/fill/hole/published_ways.h"
#include "worker/fill/region/refine_region.h"

namespace tilemend {

// Loops longer than this are not unrolled, and in scenes not filled in space.
inline constexpr int32_t kLongestSpatialLoop = 400;

struct FillOptions {
  Surface surface = kDefaultSurface;
  std::optional<double>
      tension;  // of the thin-plate surface, 1 / metre^2; none: chosen from the rim (choose_tension.h)
  WangOptions wang;
  Filler filler = Filler::kAuto;  // of closed holes
  FillerOptions filling;
  RefineOptions refine;
  const PublishedWays* published = nullptr;  // not null with Surface::kWang or a filler that is named
  bool allow_creases = false;   // in a mesh that may lie in any way: patches that fold back on the surface beside them
  bool is_single_mesh = false;  // there are no cells that messages could name
};

// The original triangles of all tiles whose extents meet the box from `lo` to `hi`, at their positions in the tiles.
using SurfaceNear = std::function<std::vector<SpaceTriangle>(const Point3& lo, const Point3& hi)>;

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_FILL_OPTIONS_H_
