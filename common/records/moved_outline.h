// How far a patch may end from its tile's own outline, where the plan has its boundary.
#ifndef TILEMEND_COMMON_RECORDS_MOVED_OUTLINE_H_
#define TILEMEND_COMMON_RECORDS_MOVED_OUTLINE_H_

#include <cstdint>
#include <span>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Metres, seen from above and along the vertical: how far a point may go from its place on the outline. Tiles and
// pieces of tiles overlap by about as much, so the patch still ends beside other surface.
inline constexpr double kMaxOutlineAside = 0.125;
inline constexpr double kMaxOutlineRise = 0.25;

// An edge of a patch's boundary, the hole on its left.
struct PlacedEdge {
  int64_t from = 0, to = 0;  // vertices, numbered in any way
  Point3 at_from, at_to;
};

// Whether a boundary may have the edges `fresh` instead of `lost`: they lead from the same vertices to the same, and
// begin no further from lost ones than two of the bounds above. O(n m).
bool MayMoveOutline(std::span<const PlacedEdge> lost, std::span<const PlacedEdge> fresh);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_MOVED_OUTLINE_H_
