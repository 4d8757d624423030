// Smooths two patches along the seam between them.
#ifndef TILEMEND_WORKER_FILL_SEAM_SMOOTH_SEAM_H_
#define TILEMEND_WORKER_FILL_SEAM_SMOOTH_SEAM_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/records/cell_holes.h"

namespace tilemend {

// What one cell has on a seam.
struct SeamSide {
  std::span<const RimVertex> vertices;
  std::span<const HolePatch> patches;
  std::span<const int32_t> holes;  // those of the patches that the seam bounds
};

// The vertices of the seam, as both sides number them (RimVertex::seam_vertex, or follows), and the mean height that
// their cells gave.
struct SeamHeightColumns {
  std::span<const int32_t> seam_vertex;
  std::span<const double> height;  // metres
};

struct SeamSmoothing {
  double gamma = 0.5;       // of eq. 5, [0, 1]
  double buffer = 3;        // >= 1, in edges of the seam
  double lattice_step = 0;  // metres, > 0
};

// Heights on the lattice.
struct SmoothedPatches {
  std::vector<double> heights;      // of the vertices of the seam
  std::vector<SmoothedPoint> a, b;  // points that move, by number, rising
};

// Wang 2021, 3.4: the points of a buffer on both sides of a seam take the height p + gamma * dp (eq. 5), where dp is
// the mean of s_i - p over the points s_i of both patches in the neighbourhood (eq. 6).
//
// The buffer is as wide as `buffer` times the wanted edge length at the nearest vertex of the seam, seen from above,
// and so is a neighbourhood around each point. All points of both patches count in it once, those of the rim too,
// also where both patches have one: at a seam's end. A vertex of the seam is one point, with its mean height. All
// heights are taken before any is changed. Heights alone move, so that no triangle turns over seen from above. O(n log
// n + pairs within reach); deterministic.
SmoothedPatches SmoothSeam(const SeamSide& a, const SeamSide& b, const SeamHeightColumns& seam,
                           const SeamSmoothing& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SEAM_SMOOTH_SEAM_H_
