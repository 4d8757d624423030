// Whether fills of water lie at their level.
#ifndef TILEMEND_WORKER_CHECK_WATER_FILL_H_
#define TILEMEND_WORKER_CHECK_WATER_FILL_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A hole of a tile that was filled as water.
struct WaterHole {
  Point2 centre{0, 0};
  double lowest = 0, highest = 0;  // metres; different where the water falls
};

struct WaterFinding {
  bool is_found = false;    // some added surface lies at the hole's centre, or around it
  int64_t vertices = 0;     // added vertices inside the fill
  std::vector<Point3> off;  // those that are not within kLevelTolerance of the level
  // The same of vertices on the boundary that no original triangle of the tile has. They may be of the shore in another
  // tile, else they lie on a seam.
  std::vector<Point3> off_at_seam = {};
};

// The lattice of new vertices is 2^-10 m; text formats round to it exactly.
inline constexpr double kLevelTolerance = 0.001;

// For each hole: the vertices inside its fill, the connected piece of added triangles at its centre. Where no piece is
// there, the piece around the centre that lies best at the level. Vertices of original
// surface and on walls do not count: they belong to the shore. The new triangles of `tile` are in `added`. Pure. O(n
// log n + holes * added).
std::vector<WaterFinding> CheckWaterFills(const TriMesh& tile, const std::vector<bool>& added,
                                          const std::vector<WaterHole>& holes);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_WATER_FILL_H_
