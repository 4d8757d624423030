// The boundary of a region of a plane on a lattice, and the new points inside it.
#ifndef TILEMEND_WORKER_FILL_REGION_PLANAR_REGION_H_
#define TILEMEND_WORKER_FILL_REGION_PLANAR_REGION_H_

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/lattice.h"
#include "worker/fill/region/refine_region.h"

namespace tilemend {

// Points of a plane on the lattice of the window around them.
struct PlanarPoints {
  LatticeWindow window;
  std::vector<LatticePoint> points;
  std::vector<double> sizes;  // wanted edge lengths, in steps of the lattice
};

//   flat   at least one point, metres
//   sizes  wanted edge length at each, metres
PlanarPoints RoundToWindow(std::span<const Point2> flat, std::span<const double> sizes);

// Triangulates the region that `segments` bound again, with those of its new points that are kept. Points that come to
// lie on a segment or on another point are left out too. O(n log n).
void KeepNewPoints(const std::vector<bool>& kept, std::span<const LatticePoint> points,
                   std::span<const RegionSegment> segments, RefinedRegion& region);

// Moves each new point to the first of `places(where it is)` that lies on the window's lattice and turns over no
// triangle. Leaves out points that can go nowhere. Metres. O(n log n).
void MoveNewPoints(const LatticeWindow& window, const std::function<std::array<Point2, 2>(const Point2&)>& places,
                   std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                   RefinedRegion& region);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_REGION_PLANAR_REGION_H_
