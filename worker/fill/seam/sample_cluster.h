// The surface of a whole cluster, sampled along its seams.
#ifndef TILEMEND_WORKER_FILL_SEAM_SAMPLE_CLUSTER_H_
#define TILEMEND_WORKER_FILL_SEAM_SAMPLE_CLUSTER_H_

#include <optional>
#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/fill_options.h"

namespace tilemend {

// Height and Laplacian of the cluster's surface at a vertex on a seam or at the end of one, or at a new vertex without
// a segment that lies inside. Or its height under a vertex on an object; with walls (HoldOut::walls) at any vertex of
// the rim.
struct SurfaceSample {
  int32_t seam_vertex = 0;
  double height = 0;     // metres
  double laplacian = 0;  // 1 / metre
  Point2 slope{0, 0};    // the mean of the triangles around it
};

// As many as one solve may have, whatever the cluster's size.
inline constexpr int64_t kMostClusterUnknowns = 250'000;

struct ClusterSurface {
  std::vector<SurfaceSample> samples;
  std::optional<HoldOut> hold_out;  // where the options leave the tension open
};

// The first level of the thin-plate surface (docs/architecture.md): triangulates the holes of a cluster together, seams
// included, and solves for its heights from the rims and the slopes of the band. With heights and Laplacians known
// along the seams each cell's own solve gives the surface of the whole.
//
// Where that would take more than `most_unknowns` unknowns, triangles and seam vertices are made coarser by powers of
// two until it does not, and the seam vertices between those that were kept interpolated along the seam; the rim stays
// whole.
//
// Folds of the boundary seen from above (vertical edges) are cut off as FillHoles does. Heights of seam vertices need
// not be known; those that are stay, as where water ends. Nothing if what remains bounds no region, or a new vertex of
// a seam is in a fold.
std::optional<ClusterSurface> SampleCluster(const CellHoles& cluster, const FillOptions& options,
                                            int64_t most_unknowns = kMostClusterUnknowns);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SEAM_SAMPLE_CLUSTER_H_
