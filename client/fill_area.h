// Whether the fills of a tile are as large as its holes.
#ifndef TILEMEND_CLIENT_FILL_AREA_H_
#define TILEMEND_CLIENT_FILL_AREA_H_

#include <optional>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// "cell 2,3: fills of 12.0 m2, holes of 15.0 m2" if the fills of the tile differ from its `holes`, in m2; else none. A
// fill is as large from above as its hole, also where both reach over the sides of the cell. With `tiles_overlap` fills
// go on over the sides, and holes are measured up to them: only what lies in the cell counts. A tile without fills has
// no holes. Cost O(triangles).
std::optional<std::string> FillAreaFault(const Grid& grid, CellId cell, double holes, bool tiles_overlap,
                                         const TriMesh& after, const std::vector<bool>& added);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_FILL_AREA_H_
