// Fills a closed hole in parts, along the sharp edges that go through it.
#ifndef TILEMEND_WORKER_FILL_FEATURE_FILL_H_
#define TILEMEND_WORKER_FILL_FEATURE_FILL_H_

#include <optional>

#include "common/grid/cell_holes.h"
#include "worker/fill/cell_band.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {

// Carries the creases that enter the hole through it (feature_curves.h), with vertices as far apart as the triangles
// there are large, and fills each part on its own: over its plane, or in space where it has none (chart_fill.h). Both
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

#endif  // TILEMEND_WORKER_FILL_FEATURE_FILL_H_
