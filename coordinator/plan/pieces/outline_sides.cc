#include "coordinator/plan/pieces/outline_sides.h"

#include <algorithm>
#include <cmath>

namespace tilemend {

bool OnOneSide(const Point3& p, const Point3& q, CellId tile, const GridLines& lines) {
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    return std::abs(lines.Inside(p, tile, side)) <= lines.tolerance &&
           std::abs(lines.Inside(q, tile, side)) <= lines.tolerance;
  });
}

bool FaceEachOther(const Point3& p, const Point3& q, CellId tile, const GridLines& lines, double plane) {
  return OnOneSide(p, q, tile, lines) || (p - q).cwiseAbs().minCoeff() <= plane;
}

}  // namespace tilemend
