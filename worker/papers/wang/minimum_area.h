// Triangulation of a closed loop with the least area.
#ifndef TILEMEND_WORKER_PAPERS_WANG_MINIMUM_AREA_H_
#define TILEMEND_WORKER_PAPERS_WANG_MINIMUM_AREA_H_

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Triangulates a loop in space without new points, of all ways the one of least area. This is the minimum area method
// that Wang 2021, 3.3, takes from its reference 10 (dynamic programming after Barequet and Sharir 1995, Liepa 2003, 3).
//   loop  positions in order; at least 3. A loop may pass one place several times
//   joins whether a new edge may run between loop[i] and loop[k], i < k
//   fits  whether triangle loop[i], loop[j], loop[k], i < j < k, may be made; asked last, only where it matters
//   is_cancelled  asked n^2 times; once true there is soon no result. None: never
// Returns triangles over loop indices, oriented like the loop; empty if there is no triangulation of such triangles
// with area. O(n^3) time, at most 14 n^2 bytes.
std::vector<Triangle> TriangulateLeastArea(std::span<const Point3> loop,
                                           const std::function<bool(int32_t, int32_t)>& joins,
                                           const std::function<bool(int32_t, int32_t, int32_t)>& fits,
                                           const std::function<bool()>& is_cancelled = {});

}  // namespace tilemend

#endif  // TILEMEND_WORKER_PAPERS_WANG_MINIMUM_AREA_H_
