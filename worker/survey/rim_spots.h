// Where to look at the surface to see what a hole's surroundings are like.
#ifndef TILEMEND_WORKER_SURVEY_RIM_SPOTS_H_
#define TILEMEND_WORKER_SURVEY_RIM_SPOTS_H_

#include <array>
#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/records/survey_record.h"

namespace tilemend {

// A place within a triangle of a tile.
struct RimSpot {
  int32_t vertex = 0;                  // into SurveyRecord::vertices: what the place stands for
  int32_t triangle = 0;                // of the tile
  std::array<double, 3> weights = {};  // of its corners, sum 1
};

// A spot for every boundary vertex at which a boundary edge begins. It is beside the middle of that edge, a little
// inside its triangle, as images bleed at the outlines of their charts. The `record` was surveyed from `mesh`. In order
// of the triangles; cost linear in the triangles, with a look-up for each vertex near the boundary.
std::vector<RimSpot> RimSpots(const TriMesh& mesh, const SurveyRecord& record);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SURVEY_RIM_SPOTS_H_
