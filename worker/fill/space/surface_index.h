// The triangles of meshes by where they lie.
#ifndef TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
#define TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_

#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/mesh_view.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

// Finds the triangles of a mesh near a place: in bins over the plane, some 16 to a bin. Building it is linear; memory
// is about 8 bytes a triangle, and nothing of the mesh is copied.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const MeshView& mesh);  // what it views outlives the index

  // Appends the triangles whose extents meet the box from lo to hi, each once. Their order depends on the mesh and the
  // box alone. Cost: the triangles over the box's shadow.
  void AppendNear(const Point3& lo, const Point3& hi, std::vector<SpaceTriangle>& found) const;

 private:
  MeshView mesh_;
  BinGrid bins_;  // of triangles
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
