// Whether heights along seams are what was asked for.
#ifndef TILEMEND_COORDINATOR_CHECK_SAMPLE_CHECK_H_
#define TILEMEND_COORDINATOR_CHECK_SAMPLE_CHECK_H_

#include <cstdint>
#include <span>

#include "absl/status/status.h"
#include "common/records/cell_holes.h"

namespace tilemend {

// Checks the samples of the surface of a cluster, in columns. Returns kInvalidArgument, saying what is wrong first,
// unless there are none, or exactly one for each vertex of `asked` that is new, on an object, or on a seam; at most one
// for a new vertex without a segment. If it is ground with walls, there are some, with one for every vertex of which
// the number was told, and some rim stands on objects. Each must have a finite Laplacian and slope, and a height no
// further from those of the rim than the holes are large. The band is not needed. O(n log n).
struct ClusterColumns {
  std::span<const int32_t> seam_vertex;
  std::span<const double> height, laplacian, slope_x, slope_y;
};
absl::Status CheckClusterSamples(const CellHoles& asked, bool has_walls, const ClusterColumns& given);

// The same for samples of one layer: heights at the seam vertices of `asked` without a known height. One vertex may
// have several, from holes that share it.
absl::Status CheckLayerSamples(const CellHoles& asked, std::span<const int32_t> seam_vertex,
                               std::span<const double> height);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_CHECK_SAMPLE_CHECK_H_
