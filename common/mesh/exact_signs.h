// Exact orientation of points with any double coordinates.
#ifndef TILEMEND_COMMON_MESH_EXACT_SIGNS_H_
#define TILEMEND_COMMON_MESH_EXACT_SIGNS_H_

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The sign of the volume of tetrahedron a, b, c, d. It is 1 if d lies on the side that triangle a, b, c faces, from
// which it is seen counter-clockwise. It is -1 if d is on the other side, 0 if on its plane. Exact:
// floating-point arithmetic where its error bound decides, of double or else long double, else expansions (Shewchuk
// 1997). No overflow or underflow up to 1e90, and differences down to 1e-90.
int SideOfPlane(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

// The sign of the area of a, b, c, positive if counter-clockwise. Exact, in the same way.
int TurnOf(const Point2& a, const Point2& b, const Point2& c);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_EXACT_SIGNS_H_
