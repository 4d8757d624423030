// Delaunay refinement of a planar region with triangle sizes graded from the rim inward.
//
// Segments are never split: they are original edges, or seams that a neighbour shares. New points go to the lattice.
// Source: Ruppert 1995 / Shewchuk 2002 / Ungor 2009 (off-centres) with segment splitting replaced
// by rejection; sizing after Persson 2006 (gradient-limited size function). Cost O(n log n); deterministic.
#ifndef TILEMEND_WORKER_FILL_REGION_REFINE_REGION_H_
#define TILEMEND_WORKER_FILL_REGION_REFINE_REGION_H_

#include <functional>
#include <span>
#include <vector>

#include "common/mesh/mesh_limits.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

struct RefineOptions {
  // Ratio of the edge lengths of neighbouring triangles inward from the rim; >= 1. 1 and `uniform` mean no growth.
  double gradation = 1.3;
  // Largest edge length as a multiple of the mean rim edge of the region; >= 1.
  double size_limit = 16.0;
  // Keeps the rim's size throughout: the size inside is interpolated from the rim's.
  bool uniform = false;
  // At most this many new points; reaching it stops refinement (still valid).
  int64_t max_new_points = kMaxResultPoints;
  // Asked now and then; true ends the refinement, and nobody wants what comes of it. None: never.
  std::function<bool()> is_cancelled = {};
  bool cancelled() const { return is_cancelled && is_cancelled(); }
};

struct RefinedRegion {
  std::vector<LatticePoint>
      new_points;                     // point i of `triangles` with i >= points.size() is new_points[i - points.size()]
  RegionTriangulation triangulation;  // conflicts as TriangulateRegion reports them
};

// Triangulates the regions that `segments` bound and refines them.
//   points, segments  as for TriangulateRegion
//   size              wanted edge length at each point, in lattice steps; for points of no segment ignored
// Guarantee: every triangle is counter-clockwise with area > 0, and no new point is on a segment. Triangles away from
// the rim reach quality (2 * inradius / circumradius) >= 0.3, unless the rim itself forces less. That is so for small
// angles between segments, and for rim vertices closer together than their size.
RefinedRegion RefineRegion(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                           std::span<const double> size, const RefineOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_REGION_REFINE_REGION_H_
