// Constrained Delaunay triangulation of planar regions given by directed segments, on exact integer predicates.
//
// A region is described by segments that have it on their left: the outer boundary counter-clockwise, islands
// clockwise, in any order. One call may have any number of separate regions, and they may touch themselves or each
// other at vertices ("pinches"). The caller need not trace polygons: a flood fill from the sides of the segments finds
// which triangles are inside.
//
// Source: incremental insertion in Hilbert order with Lawson flips; constraint insertion after Sloan 1993 / Anglada
// 1997. Cost O(n log n) expected; more where segments cross many edges of the triangulation of their ends, as the teeth
// of a comb do. Deterministic: the result depends on the input values alone.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_REGION_TRIANGULATION_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_REGION_TRIANGULATION_H_

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/lattice.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A boundary segment between two points; the region lies to the left of from -> to.
using RegionSegment = DirectedEdge;

// Why a set of segments bounds no region.
struct RegionConflict {
  enum class Kind {
    kCoincidentPoints,  // two points that segments use have the same lattice position: first, second are points
    kCrossing,          // segments first and second cross, or overlap
    kPointOnSegment,    // point second lies in the interior of segment first
    kDegenerate,        // segment first joins a point with itself, or stands twice in the list (second)
    kInsideOut,         // segment first has both the inside and the outside on one side: the sides do not fit together
    kCancelled,         // at segment first
  };
  Kind kind;
  int32_t first;
  int32_t second;
};

struct RegionTriangulation {
  // Inside triangles only, counter-clockwise. Indices into the points.
  std::vector<Triangle> triangles;
  // neighbors[t][k]: the inside triangle across the edge opposite to corner k, or -1 where that edge is a segment.
  std::vector<std::array<int32_t, 3>> neighbors;
  // The connected part (across shared edges) each triangle belongs to, numbered from 0 in order of the lowest segment
  // index on its boundary.
  std::vector<int32_t> component;
  int32_t component_count = 0;
  // For each segment, the triangle on its left.
  std::vector<int32_t> segment_triangle;
  // Not empty: the segments bound no region; everything above is empty. Up to 64 conflicts are listed.
  std::vector<RegionConflict> conflicts;
};

// Triangulates the regions that `segments` bound. Free points, which no segment uses, are inserted too if they lie
// inside a region and on no other point; others are ignored. `is_cancelled`, if given, is asked at each segment.
// Precondition: segment indices are in range (CHECKed).
RegionTriangulation TriangulateRegion(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                                      const std::function<bool()>& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_REGION_TRIANGULATION_H_
