// Pairs of boxes that meet.
#ifndef TILEMEND_WORKER_CHECK_BOX_PAIRS_H_
#define TILEMEND_WORKER_CHECK_BOX_PAIRS_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <span>

namespace tilemend {

// Calls found(a, b), a < b, once for every pair of boxes that meet. O(n log n) for boxes that are small beside their
// spread, and the pairs.
void ForBoxPairs(std::span<const Eigen::AlignedBox3d> boxes, const std::function<void(int32_t a, int32_t b)>& found);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_BOX_PAIRS_H_
