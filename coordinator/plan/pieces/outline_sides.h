// Whether two places at the outline of a tile can be joined along it.
#ifndef TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_SIDES_H_
#define TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_SIDES_H_

#include "coordinator/plan/rim/grid_lines.h"

namespace tilemend {

// Places that agree in a coordinate to this lie in one plane, metres.
inline constexpr double kSamePlane = 2e-2;
// The same where pieces end raggedly, if nothing fits better.
inline constexpr double kLoosePlane = 0.2;

// Whether both lie near one of the four sides of their tile (GridLines::tolerance).
bool OnOneSide(const Point3& p, const Point3& q, CellId tile, const GridLines& lines);

// Whether they lie on one side of the tile's outline, or in one plane of constant x, y or z to within `plane` metres.
bool FaceEachOther(const Point3& p, const Point3& q, CellId tile, const GridLines& lines, double plane);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_PIECES_OUTLINE_SIDES_H_
