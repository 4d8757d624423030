// Fills one level of detail of a tile with the surface that its finest level got.
#ifndef TILEMEND_COMMON_ASSEMBLE_FILL_LEVEL_H_
#define TILEMEND_COMMON_ASSEMBLE_FILL_LEVEL_H_

#include <vector>

#include "common/codec/mesh_file.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

struct LevelFill {
  FilePatch patch;
  std::vector<Point2> open;  // the middle of each hole that gets nothing: its outline cannot be triangulated
};

// The patch of a coarser level. It covers what the finest level covers, by its own surface or by its patch, and `level`
// does not: beside the finest patch, and wherever this level was cleared. So it ends at the rim that `level` itself
// has. At its rim it uses rim vertices of `level`. Other vertices are vertices of the finest patch, as many as fit the
// length of the level's edges. So water has the same height to the bit, and two levels differ by at most the coarser
// one's edge times the slope. A triangle that was cleared may reach beyond the finest patch. There the vertices are
// those that the level had. Triangles take the material that the finest patch has there, or nearest.
//   level    the coarser surface, in metres: one level of detail of the tile, without what was cleared
//   finest   the surface of the finest level
//   patch    what was added to it; indices as AppendPatch takes them
//   cleared  the triangles that were taken out of `level`
// No patch for holes whose patch stands upright: from above they have no area. Pure, deterministic. O(n log n), and if
// an outline cannot be triangulated: each hole times the points in it.
LevelFill FillLevel(const TriMesh& level, const TriMesh& finest, const FilePatch& patch, const TriMesh& cleared = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_FILL_LEVEL_H_
