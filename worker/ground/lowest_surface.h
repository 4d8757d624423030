// The raster of the lowest surface of a mesh.
#ifndef TILEMEND_WORKER_GROUND_LOWEST_SURFACE_H_
#define TILEMEND_WORKER_GROUND_LOWEST_SURFACE_H_

#include "common/mesh/tri_mesh.h"
#include "common/records/ground_raster.h"

namespace tilemend {

// The lowest height of the mesh in each square: of its vertices, and of its triangles at four places of each square. So
// large triangles count in every square that they cover. Places are those of the lattice: tiles that overlap agree on
// them.
//
//   square  metres, > 0
//
// Returns an empty raster for a mesh without triangles, and for one that spans more than kMostRasterSquares squares.
// Cost: linear in the triangles and the squares that they cover. Pure.
GroundRaster LowestSurface(const TriMesh& mesh, double square);

// A tile spans at most 1024 squares a side (RasterSquareFor) and its margins.
inline constexpr int64_t kMostRasterSquares = int64_t{1} << 24;

}  // namespace tilemend

#endif  // TILEMEND_WORKER_GROUND_LOWEST_SURFACE_H_
