// Fills one smooth part of a hole.
#ifndef TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_
#define TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// Corners as in HolePatch: k >= 0 is rim vertex k of the CellHoles, -1 - k is new_points[k] of the patch (a point of a
// curve).
struct ChartCorner {
  int32_t corner = 0;
  // Unit normal of the surface that goes on into the chart, evened out along the rim; zero on a curve.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool ends_crease = false;
};

// A region of a hole that its boundary and feature curves bound.
struct Chart {
  std::vector<std::vector<ChartCorner>> loops;  // with the region on the left seen from outside; the outer one first
};

// Fills a chart over its plane: refined, with the heights that bend least. The slope goes on from the surface beside
// the rim, but not across creases. Appends to `patch`; false, with the patch as it was, if the chart's boundary crosses
// itself on the plane of its surroundings, on its own, and on the one that all of its surroundings face most nearly.
// Without a tension in the options there is none: a chart has too little rim of its own to choose one by. Cost as
// RefineRegion and SolveThinPlate.
bool FillChartOverPlane(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                        HolePatch& patch);

// Fills a chart that lies over no plane, or steeply: a minimum-weight triangulation of its boundary is unrolled into
// the plane without stretching, refined there, and lifted to the surface of least bending in space (fair_surface.h).
// Appends to `patch`; false, with the patch as it was, if the chart has islands or more than kLongestSpatialLoop
// boundary vertices, has no triangulation, or covers itself when it is unrolled. O(boundary^3 + new * boundary) and the
// cost of FairSurface.
bool FillChartInSpace(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                      HolePatch& patch);

// The same over given triangles of the chart's loop (their corners are places on it), the share `bend` of the way to
// the surface of least bending: 0 keeps to the triangles, so that the patch crosses little that they do not. False,
// with the patch as it was, if there are no triangles, or as above.
bool FillChartOver(const CellHoles& cell, const CellBand& band, const FillOptions& options, const Chart& chart,
                   std::vector<Triangle> triangles, double bend, HolePatch& patch);

// Whether the surface beside a chart is too steep over every plane for triangles that are well shaped there to be well
// shaped in space.
bool IsSteep(const CellHoles& cell, const CellBand& band, const Chart& chart, const HolePatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_PART_FILL_H_
