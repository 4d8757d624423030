// The triangles of meshes by where they lie.
#ifndef TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
#define TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_

#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/mesh_view.h"
#include "common/mesh/tri_mesh.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

// Finds the triangles of a mesh near a place, in bins over the plane. A bin has 16 triangles in the mean, or more: a
// triangle is in at most 4 bins in the mean. Building is linear. Memory is 4 bytes for each bin that a triangle is in,
// so at most some 16 bytes a triangle. Nothing of the mesh is copied.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(const MeshView& mesh);  // what it views outlives the index
  explicit SurfaceIndex(const TriMesh&& mesh) = delete;

  // Appends the triangles whose extents meet the box from lo to hi, each once. Their order depends on the mesh and the
  // box alone. Cost: linear in the triangles of the bins that the box meets seen from above, at any height.
  void AppendNear(const Point3& lo, const Point3& hi, std::vector<SpaceTriangle>& found) const;

 private:
  MeshView mesh_;
  BinGrid bins_;  // of triangles
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
