// The seams of a cluster as chains of vertices that a coarse solve may thin out.
#ifndef TILEMEND_WORKER_FILL_SEAM_SEAM_CHAINS_H_
#define TILEMEND_WORKER_FILL_SEAM_SEAM_CHAINS_H_

#include <span>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// A straight stretch of seam from one junction, grid corner or rim vertex to the next.
struct SeamChain {
  std::vector<int32_t> vertices;           // into CellHoles::vertices, in order; at least two
  bool forward = false, backward = false;  // the directions in which holes have it on their boundary
};

// All seam segments of the holes, each in one chain. Cost O(n log n); deterministic.
std::vector<SeamChain> SeamChains(const CellHoles& cluster);

// Positions in `chain.vertices` that stay when neighbours are to be at least `factor` times their size apart: always
// the first and the last. Rising.
std::vector<size_t> ThinnedChain(const CellHoles& cluster, const SeamChain& chain, double factor);

// The value at each of `at` (rising), linear between values[i] at knots[i]. At least two knots, rising; `at` within
// them.
std::vector<double> LinearAlong(std::span<const double> knots, std::span<const double> values,
                                std::span<const double> at);

// The value at each of `at` (rising) of the curve through values[i] at knots[i]: cubic Hermite, with the slopes of the
// parabolas through three neighbouring knots; straight between two. At least two knots, rising; `at` within them.
std::vector<double> InterpolatedAlong(std::span<const double> knots, std::span<const double> values,
                                      std::span<const double> at);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SEAM_SEAM_CHAINS_H_
