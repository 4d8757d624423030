// Fills a closed hole in parts, along the sharp edges that go through it.
#ifndef TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_
#define TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_

#include <optional>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// Carries the creases that enter the hole through it (crease_curves.h), with vertices as far apart as the triangles
// there are large, and fills each part on its own: over its plane, or in space where it has none (part_fill.h). Both
// parts at a crease close on its vertices. Islands belong to the part that they lie in; creases may end at them.
// Nothing if no crease goes through the hole, or a part cannot be filled. The caller checks that the patch is sound.
std::optional<HolePatch> FillAlongFeatures(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                           const FillOptions& options);

// Fills a closed hole as one part in space (FillChartInSpace). Nothing if that cannot be done.
std::optional<HolePatch> FillHoleInSpace(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                         const FillOptions& options);

// Fills a closed hole of one loop as one part over given triangles of it (FillChartOver). Nothing if that cannot be
// done.
std::optional<HolePatch> FillHoleOver(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                      const FillOptions& options, std::vector<Triangle> triangles, double bend);

// Fills a closed hole as one part over a plane (FillChartOverPlane). Nothing if that cannot be done.
std::optional<HolePatch> FillHoleOverPlane(const CellHoles& cell, const CellHole& hole, const CellBand& band,
                                           const FillOptions& options);

// Whether the surface around a closed hole is too steep for a good fill over any plane.
bool IsSteepHole(const CellHoles& cell, const CellHole& hole, const CellBand& band);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_CREASE_FILL_H_
