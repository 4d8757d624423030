// Positions as holes.geojson has them, rounded to millimetres.
#ifndef TILEMEND_CLIENT_ROUNDED_PLACE_H_
#define TILEMEND_CLIENT_ROUNDED_PLACE_H_

#include "common/mesh/tri_mesh.h"

namespace tilemend {

inline constexpr double kOfRounding = 0.0006;  // metres in x and y: half a millimetre, and what the origin takes

// Whether `rounded` is p, seen from above and rounded.
inline bool IsRoundedTo(const Point2& rounded, const Point3& p) {
  return (rounded - p.head<2>()).cwiseAbs().maxCoeff() <= kOfRounding;
}

// Whether the segment from a to b is the edge from p to q or from q to p, seen from above and rounded.
inline bool IsRoundedTo(const Point2& a, const Point2& b, const Point3& p, const Point3& q) {
  return (IsRoundedTo(a, p) && IsRoundedTo(b, q)) || (IsRoundedTo(a, q) && IsRoundedTo(b, p));
}

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_ROUNDED_PLACE_H_
