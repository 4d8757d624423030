// The rim of the surface: the boundary edges that remain when the tiles are put together, linked to loops.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct RimPoint {
  CellId tile;  // of the first tile (by cell) that has it
  int32_t index = 0;
  Point3 position{0, 0, 0};
  Eigen::Vector3d normal{0, 0, 1};
  double centroid_height = 0;
  double size = 0;  // mean length of the rim edges here
};

struct RimEdge {
  int32_t from = 0, to = 0;  // points; surface on the left
  CellId owner;              // whose triangle it bounds
  CellId label;              // the cell that closes on it; a square outside the area: nobody
};

struct Rim {
  std::vector<RimPoint> points;
  std::vector<RimEdge> edges;
  std::vector<std::vector<int32_t>> loops;          // edges in order; each edge is in one loop or in `unlinked`
  std::vector<int32_t> unlinked;                    // edges of chains that do not close (non-manifold surface)
  int32_t continuous = 0;                           // groups of loops that touch
  std::map<CellId, std::vector<int32_t>> point_of;  // per tile: the point of each boundary vertex of its record
};

// Puts the tiles together: matches boundary edges of different tiles at equal positions (`weld_tiles`), drops the
// matched ones, and links the others to loops. Where several holes touch at a vertex each loop turns back into its own
// hole (Zhang 2022, 3.3).
Rim BuildRim(const PlanInput& input, bool weld_tiles);

// New vertices lie on a lattice of `lattice_step` metres: triangles of a few steps would be bent by rounding. Raises
// sizes below 64 steps to that, or to half the mean size of the points on edges if this is less. (Clipped tiles have
// slivers along their borders, with edges far below a millimetre.)
void RaiseSmallSizes(double lattice_step, Rim& rim);

// Raises sizes at short runs of short edges between long ones, to 0.6 of a long edge's length less the way from it
// along the loop. A short edge between long ones makes one triangle poor, whatever is done; triangles of its size
// around it would make those on the long edges poor as well, and many of them.
void RaiseSizesAtShortEdges(Rim& rim);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_RIM_H_
