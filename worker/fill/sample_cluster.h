// The surface of a whole cluster, sampled along its seams.
#ifndef TILEMEND_WORKER_FILL_SAMPLE_CLUSTER_H_
#define TILEMEND_WORKER_FILL_SAMPLE_CLUSTER_H_

#include <vector>

#include "common/grid/cell_holes.h"
#include "worker/fill/fill_holes.h"

namespace tilemend {

// Height and Laplacian of the cluster's surface at a vertex on a seam or at the end of one.
struct SurfaceSample {
  int32_t seam_vertex = 0;
  double height = 0;     // metres
  double laplacian = 0;  // 1 / metre
};

// The first level of the thin-plate surface (design, "Surface"): triangulates the holes of a cluster together, seams
// included, and solves for its heights from the rims and the slopes of the band. With heights and Laplacians known
// along the seams each cell's own solve gives the surface of the whole.
//
// Heights of seam vertices need not be known. Nothing if the cluster's boundary bounds no region.
std::vector<SurfaceSample> SampleCluster(const CellHoles& cluster, const FillOptions& options);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SAMPLE_CLUSTER_H_
