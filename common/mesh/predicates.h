// Inline exact predicates on 32-bit lattice coordinates, for the inner loops of triangulation. Not for other folders'
// use beyond the triangulators; everyone else calls lattice.h.
#ifndef TILEMEND_COMMON_MESH_PREDICATES_H_
#define TILEMEND_COMMON_MESH_PREDICATES_H_

#include <cstdint>

#include "common/mesh/lattice.h"

namespace tilemend::internal {

// Coordinates are below this in magnitude.
inline constexpr int64_t kCoordinateBound = int64_t{1} << 29;

// A lattice point in half the memory: the triangulators are bound by cache misses, not by arithmetic.
struct Point32 {
  int32_t x = 0;
  int32_t y = 0;
  bool operator==(const Point32&) const = default;
};

inline Point32 Narrow(LatticePoint p) { return {static_cast<int32_t>(p.x), static_cast<int32_t>(p.y)}; }
inline LatticePoint Widen(Point32 p) { return {p.x, p.y}; }

// Twice the signed area of a, b, c. Differences are below 2^30, so the value is below 2^61: exact.
inline int64_t Turn(Point32 a, Point32 b, Point32 c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{c.x} - a.x);
}

// The dot product of a->b and a->c.
inline int64_t Dot(Point32 a, Point32 b, Point32 c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.x} - a.x) + (int64_t{b.y} - a.y) * (int64_t{c.y} - a.y);
}

// The in-circle determinant of a, b, c (counter-clockwise) and d: > 0 if d lies inside. The lifts and the minors are at
// most 2^61 and stay in 64 bits; only the three last products need 128. That is about as fast as a floating-point
// filter, so there is none.
inline __int128 InCircleDeterminant(Point32 a, Point32 b, Point32 c, Point32 d) {
  const int64_t ax = int64_t{a.x} - d.x, ay = int64_t{a.y} - d.y;
  const int64_t bx = int64_t{b.x} - d.x, by = int64_t{b.y} - d.y;
  const int64_t cx = int64_t{c.x} - d.x, cy = int64_t{c.y} - d.y;
  return static_cast<__int128>(ax * ax + ay * ay) * (bx * cy - cx * by) +
         static_cast<__int128>(bx * bx + by * by) * (cx * ay - ax * cy) +
         static_cast<__int128>(cx * cx + cy * cy) * (ax * by - bx * ay);
}

}  // namespace tilemend::internal

#endif  // TILEMEND_COMMON_MESH_PREDICATES_H_
