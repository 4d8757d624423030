// Regions of the plane by winding numbers: what is inside of boundaries that cross themselves.
#ifndef TILEMEND_COMMON_MESH_WINDING_WOUND_REGION_H_
#define TILEMEND_COMMON_MESH_WINDING_WOUND_REGION_H_

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/lattice.h"

namespace tilemend {

// A box of the lattice, its sides included.
struct LatticeBox {
  LatticePoint lo, hi;
};

// Where the boundary of a region has a corner that is none of the points.
struct RegionCorner {
  LatticePoint place;
  std::vector<int32_t> through;  // the segments that pass there, rising; none: a corner of the box
};

// The boundary of a region: simple, each loop once, the region on the left.
struct WoundRegion {
  std::vector<RegionCorner> corners;   // numbered on from the points
  std::vector<DirectedEdge> segments;  // between points and corners, loop by loop
};

enum class Winding {
  kInside,   // where the segments wind around at least once, counter-clockwise; with a box: and in the box
  kOutside,  // the rest of the box
};

// The region of points that directed segments wind around. They may cross, touch and fold over themselves; chains that
// do not close are closed by a straight way. Of several points at one place, one stands for all.
// Source: Vatti 1992, as Clipper has it (positive winding). O((n + k) log n) for n segments and k crossings, and for
// each corner the segments near it. Deterministic. Crossings are rounded to the lattice.
WoundRegion FindWoundRegion(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments,
                            const std::optional<LatticeBox>& box = {}, Winding winding = Winding::kInside);

// The region that either of two boundaries winds around: the segments up to `first_of_second`, and the others. Unlike
// that of all segments together, a fold of the one that winds the other way takes nothing away from the other.
WoundRegion UniteWoundRegions(std::span<const LatticePoint> points, std::span<const DirectedEdge> segments,
                              size_t first_of_second, const LatticeBox& box);

// What has to be added to boundary `inner` to make it boundary `outer`, as loops. These are edges of `outer` and
// reversed edges of `inner`, without those that both have. Both close. No loop passes a vertex twice; two edges to and
// fro are no loop.
std::vector<std::vector<int32_t>> LoopsBetween(std::span<const DirectedEdge> outer,
                                               std::span<const DirectedEdge> inner);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_WINDING_WOUND_REGION_H_
