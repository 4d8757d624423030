// One cell with hand-made boundaries, for tests of the holes in it.
#ifndef TILEMEND_TESTS_SUPPORT_HOLE_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_HOLE_SCENE_H_

#include <set>
#include <vector>

#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_site.h"
#include "tests/support/rim_builders.h"

namespace tilemend {

// Cell (0, 0) of 10 m and the rim loops of its tile; all of them inside, until a test says otherwise.
struct HoleScene {
  explicit HoleScene(const std::vector<Loop3>& loops) : area({{0, 0}}), lines(LinesOf(area, 10)), rim(RimOf(loops)) {
    for (const RimPoint& p : rim.points) position.push_back(p.position);
    for (const auto& loop : rim.loops) boundary.closed_loops.push_back(Reversed(rim, loop));
  }
  HoleScene(const HoleScene&) = delete;

  HoleSite Site() const { return {area, lines, rim, position}; }

  std::set<CellId> area;
  GridLines lines;
  Rim rim;
  std::vector<Point3> position;
  CellBoundary boundary;
};

// A rectangle at height z. As a rim loop it is a hole: clockwise, with the surface around it.
inline Loop3 HoleLoop(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}};
}

// As a rim loop a piece of surface.
inline Loop3 PieceLoop(double x0, double y0, double x1, double y1, double z = 0) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_HOLE_SCENE_H_
