// Long edges of a hole's boundary, split for an advancing front and whole again after it.
#ifndef TILEMEND_WORKER_PAPERS_FRONT_SPLIT_RIM_H_
#define TILEMEND_WORKER_PAPERS_FRONT_SPLIT_RIM_H_

#include <cstdint>

#include "worker/papers/front/advancing_front.h"

namespace tilemend {

// Halves the edges of a rim's loops that are longer than `longest`, and the halves likewise (Xu 2014, 3.1). The new
// points follow those of the rim; the surface itself stays as it is. Precondition: longest > 0. Gives how many are new.
int32_t SplitLongEdges(double longest, FrontRim& rim);

// Takes the points that SplitLongEdges added out of a patch, so that no edge of the surface has a vertex in its middle.
// Each moves along the boundary into one of its two neighbours there, the one that leaves the better triangles. What
// the paper does with them, it does not say.
//   rim       points that stay, the first ones
//   split     points after them that go
//   may_join  whether an edge may run between two points of the rim
// False, with the patch as it was, if one has nowhere to go.
bool TieBack(int32_t rim, int32_t split, const std::function<bool(int32_t, int32_t)>& may_join, FrontPatch& patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_FRONT_SPLIT_RIM_H_
