// Cuts folds off a hole's boundary, so that what remains is simple on its plane.
#ifndef TILEMEND_WORKER_FILL_REGION_FOLD_CUTTING_H_
#define TILEMEND_WORKER_FILL_REGION_FOLD_CUTTING_H_

#include <functional>
#include <span>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// A longer run is no fold but a part of the hole, and too long to be filled well without new vertices.
inline constexpr int32_t kLongestFold = 60;

struct CutBoundary {
  // What remains: segments of the boundary and the chords, each chord where its run was.
  std::vector<RegionSegment> segments;
  // For each segment, the one it was, or -1 for a chord.
  std::vector<int32_t> original;
  // What was cut off: the points of each run in order. The last one's way back to the first is the chord, unless the
  // two are one point (left out at the end): then the run was a loop of its own. A later run may have the chord of an
  // earlier one as an edge.
  std::vector<std::vector<int32_t>> runs;
  bool simple = false;  // the segments bound a region
};

// Where the boundary of a hole crosses or touches itself on its plane (at a facade, under a tree, at a vertical edge)
// within kLongestFold edges along one loop, takes the shortest run around the place off by a chord that meets no other
// segment, and so on until nothing crosses. The runs have to be filled in space.
//   points, segments  as for TriangulateRegion
//   allowed           whether a chord between two points may be made (an edge that the surface has already may not)
// Cost O(folds * kLongestFold^2 * segments) at worst. Deterministic.
CutBoundary CutFolds(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                     const std::function<bool(int32_t, int32_t)>& allowed);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_REGION_FOLD_CUTTING_H_
