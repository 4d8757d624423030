// Cuts faces with more than three corners into triangles.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_CUT_POLYGON_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_CUT_POLYGON_H_

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Puts into `triangles` those of a face, by the places of its corners in it. They are a fan around its first corner if
// no triangle of that is turned over, as in every convex face. Else they are those of a constrained Delaunay
// triangulation seen along the face's normal. A face that crosses itself, or has corners that are not known yet, is a
// fan whatever its shape.
//   corners  indices of points, at least 3, none twice; points that are not there yet are not known
// O(n), or O(n log n) where it is no fan.
void CutPolygon(std::span<const int32_t> corners, std::span<const Point3> points, std::vector<Triangle>& triangles);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_CUT_POLYGON_H_
