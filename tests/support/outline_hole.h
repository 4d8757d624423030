// A hole that ends at its tile's own outline.
#ifndef TILEMEND_TESTS_SUPPORT_OUTLINE_HOLE_H_
#define TILEMEND_TESTS_SUPPORT_OUTLINE_HOLE_H_

#include <cstdint>

#include "common/records/cell_holes.h"

namespace tilemend {

// A flat square, 4 m wide, with the rim 0 (0, 0), 1 (2, 0), 2 (4, 0), 3 (4, 4), 4 (0, 4). It ends on the outline along
// y = 0, where the plan made vertex 1.
inline CellHoles HoleAtOutline() {
  CellHoles asked;
  asked.lattice_step = 1.0 / 1024;
  for (const Point3& p : {Point3(0, 0, 5), Point3(2, 0, 5), Point3(4, 0, 5), Point3(4, 4, 5), Point3(0, 4, 5)}) {
    RimVertex v;
    v.index = p.x() == 2 ? -1 : static_cast<int32_t>(asked.vertices.size());
    v.position = p;
    asked.vertices.push_back(v);
    asked.band.points.push_back(p);
  }
  asked.holes = {{7, true, {{0, 1, true}, {1, 2, true}, {2, 3, false}, {3, 4, false}, {4, 0, false}}}};
  asked.holes[0].own_outline = true;
  return asked;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_OUTLINE_HOLE_H_
