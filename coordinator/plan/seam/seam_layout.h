// Lays the seams: where grid lines run through holes.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_

#include <set>
#include <string>
#include <vector>

#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

struct SeamLayout {
  // New vertices; vertex k of the layout has number rim.points.size() + k in Seam::vertices.
  std::vector<Point2> vertices;
  std::vector<double> sizes;
  std::vector<uint8_t> lines;   // as RimVertex::lines
  std::vector<int32_t> beside;  // the rim point a hair beside it, of which it takes the height; -1: none
  std::vector<Seam> seams;
  // Stretches that could not be laid: the holes of these cells there cannot be bounded.
  std::vector<LeftOpen> failures;
  std::vector<Point2> trouble;  // the junctions there
};

// Lays a seam on every stretch of grid line inside a hole, between the cells of `area` and between them and the
// outside.
//
// A stretch runs from junction to junction (where RimEdge::label changes along a loop) or to a grid corner that lies in
// the hole. Its vertices lie on the line, as far apart as the triangles there will be large (PlanOptions); where the
// straight way would meet the rim it bends over rim points (Wang 3.3, closure cases 1 to 3: on a ragged cut a stretch
// begins and ends off the line). At the rim of the area, where a seam must keep to the line, it has a vertex beside
// each rim point that lies within kOnLine of it: a straight edge there would be the base of upright hairline triangles.
SeamLayout LaySeams(const std::set<CellId>& area, const CutLines& lines, const Rim& rim, const RimIndex& index,
                    const PlanOptions& options, double lattice_step);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_
