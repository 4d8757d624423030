// Fills of a tile, told apart.
#ifndef TILEMEND_WORKER_CHECK_FILL_PIECES_H_
#define TILEMEND_WORKER_CHECK_FILL_PIECES_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The triangles in pieces that are connected over edges; fills of two holes may touch at a vertex. Pieces in the order
// of their first triangles. Precondition: corners at one position have one number. O(n log n).
std::vector<std::vector<Triangle>> PiecesByEdges(const std::vector<Triangle>& triangles);

// The fills of a tile: its added triangles in pieces that are connected over edges.
struct TileFills {
  using Edge = std::pair<Point3, Point3>;

  std::vector<int32_t> of_triangle;     // the fill of each triangle of the tile; -1: the triangle is original
  std::vector<std::vector<Edge>> rims;  // by fill: its edges with one added triangle
};

// Corners at equal positions are one. An edge with more than two added triangles connects nothing and is on no rim, as
// fills of two holes may share it. O(n + a log a) for a added triangles.
TileFills FillsOf(const TriMesh& mesh, const std::vector<bool>& added);

struct AddedArea {
  double from_above = 0;  // triangles that face down count negative. Of a whole fill it is that of its hole
  double in_space = 0;
};

// The area of the added triangles whose middle lies between the corners lo and hi. O(n).
AddedArea AddedAreaWithin(const Point2& lo, const Point2& hi, const TriMesh& mesh, const std::vector<bool>& added);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_FILL_PIECES_H_
