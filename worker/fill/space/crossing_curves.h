// The curves along which triangles cross.
#ifndef TILEMEND_WORKER_FILL_SPACE_CROSSING_CURVES_H_
#define TILEMEND_WORKER_FILL_SPACE_CROSSING_CURVES_H_

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Two triangles that cross, the lower number first.
struct CrossingPair {
  int32_t a = 0, b = 0;
  auto operator<=>(const CrossingPair&) const = default;
};

// Tells crossings that the input has from those that it has not. Two surfaces cross along curves. A curve goes on over
// an edge of one triangle where that edge passes through the other triangle. It ends only where one of the surfaces
// does. A curve that comes to the edge of a hole in the one surface therefore goes on in every patch that closes the
// hole.
//   pairs  those of which one or both were added, sorted
// Returns of each pair whether its curve goes on between two triangles that were not added. Decided by exact signs.
// O(triangles + pairs log pairs).
std::vector<bool> ContinueCrossings(std::span<const Point3> points, std::span<const Triangle> triangles,
                                    const std::vector<bool>& is_added, std::span<const CrossingPair> pairs);

// The numbers of the triangles of a patch that cross another one where not every patch does (ContinueCrossings),
// rising.
//   surface  of the input
//   earlier  of other patches: added as well, so that a curve does not go on because it comes to them
// Precondition: patch triangles have area. O(n log n) where few extents overlap.
std::vector<int32_t> AvoidableCrossings(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface,
                                        std::span<const SpaceTriangle> earlier = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_CROSSING_CURVES_H_
