// Integer points and exact predicates for planar triangulation.
//
// All topology is decided on integers: no epsilon, no rounding, the same answer on every machine. A window of the plane
// is mapped to a local lattice of at most 2^28 steps a side. With coordinates below 2^29 in magnitude the in-circle
// determinant stays below 2^127, so 128-bit integers hold it exactly.
#ifndef TILEMEND_COMMON_MESH_LATTICE_H_
#define TILEMEND_COMMON_MESH_LATTICE_H_

#include <compare>
#include <cstdint>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A point of a local lattice; |x|, |y| < 2^29.
struct LatticePoint {
  int64_t x = 0;
  int64_t y = 0;
  auto operator<=>(const LatticePoint&) const = default;
};

// > 0 if a, b, c turn left (counter-clockwise), < 0 if right, 0 if collinear. Exact.
int Orientation(LatticePoint a, LatticePoint b, LatticePoint c);

// > 0 if d lies inside the circle through a, b, c (given counter-clockwise), < 0 outside, 0 on it. Exact.
int InCircle(LatticePoint a, LatticePoint b, LatticePoint c, LatticePoint d);

// A square window of the plane, cut into at most 2^28 steps of a power-of-two size.
class LatticeWindow {
 public:
  // The finest window that holds the box [lo, hi], grown by 1/16 of its larger side. lo <= hi. The window depends on
  // the box alone, so equal boxes give equal lattices. If a box is 2^k times as large, the step is 2^k times as long.
  LatticeWindow(const Point2& lo, const Point2& hi);

  double step() const { return step_; }
  const Point2& origin() const { return origin_; }  // a multiple of step(), where (0, 0) lies

  LatticePoint Round(const Point2& p) const;  // nearest; p inside the window
  Point2 ToMetres(LatticePoint p) const;      // exact

 private:
  Point2 origin_;
  double step_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_LATTICE_H_
