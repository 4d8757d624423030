// Lays the seams: where grid lines run through holes.
#ifndef TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_
#define TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_

#include <cstdint>
#include <vector>

#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/seam/seam_site.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Seams take rim vertices close beside them, or keep to the line where they can.
enum class SeamsOverRim { kYes, kNo };

// A new vertex on a seam.
struct SeamVertex {
  Point2 position;
  double size = 0;      // wanted edge length, metres
  uint8_t lines = 0;    // as RimVertex::lines
  int32_t beside = -1;  // the rim point a hair beside it, of which it takes the height; -1: none
};

struct SeamLayout {
  std::vector<SeamVertex> vertices;  // vertex k has number rim.points.size() + k in Seam::vertices
  std::vector<Seam> seams;
  // Stretches that could not be laid: the holes of these cells there cannot be bounded.
  std::vector<LeftOpen> failures;
  std::vector<Point2> trouble;  // the junctions there
};

// Lays a seam on every stretch of grid line inside a hole, between the cells of the area and between them and the
// outside.
//
// A stretch runs from junction to junction (junctions.h) or to a grid corner that lies in the hole. Its vertices lie on
// the line. They are spaced (seam_vertices.h) or, where the options say so, projected (projected_places.h); where tiles
// overlap, spaced ones fill wide gaps between projected ones. Where the straight way would meet the rim, the stretch
// bends over rim points. On a ragged cut a stretch begins and ends off the line. The buffer zones of Wang 2021, figure
// 7, are laid where a hole is filled (worker/papers/wang/closure_buffers.h). Deterministic.
SeamLayout LaySeams(const SeamSite& site, const ClosingCells& closing, SeamsOverRim over_rim);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_SEAM_SEAM_LAYOUT_H_
