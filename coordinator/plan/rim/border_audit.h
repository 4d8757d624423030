// How the tiles of neighbouring cells meet.
#ifndef TILEMEND_COORDINATOR_PLAN_RIM_BORDER_AUDIT_H_
#define TILEMEND_COORDINATOR_PLAN_RIM_BORDER_AUDIT_H_

#include <map>
#include <utility>
#include <vector>

#include "coordinator/plan/types/cell_side.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// How far the straight outline of a tile lies outside its cell's side, metres; only where it has a straight outline.
using OutlineOffsets = std::map<std::pair<CellId, int>, double>;

struct BorderFindings {
  std::vector<BorderAudit> borders;  // of every pair of neighbours, by the western or southern cell
  OutlineOffsets offsets;
  OutlineOffsets buffers;   // of tiles that end in a zigzag beyond the line, over their neighbour (buffered_cut.h)
  double usual_offset = 0;  // the median of all of them; 0 without any
  // Most tiles end at outlines of their own (overlap or gap). They share vertices only where they were cut from one
  // mesh.
  bool independent = false;
  bool clipped = true;  // no triangle crosses a grid line (else ragged); of no meaning when independent
};

// Classifies every border by the vertices that its tiles share and by how far their straight outlines lie off the
// grid's line. Classifies the cut of the scene by all borders. Nothing is found without a grid (PlanInput::has_grid).
// Cost linear in the tiles' boundary vertices.
BorderFindings AuditBorders(const PlanInput& input);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_RIM_BORDER_AUDIT_H_
