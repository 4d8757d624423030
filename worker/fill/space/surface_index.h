// The triangles of meshes by where they lie.
#ifndef TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
#define TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_

#include <cstdint>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

// Finds the triangles of a mesh near a place: in bins over the plane, some 16 to a bin. Building it is linear; memory
// is that of the mesh and about 8 bytes a triangle.
class SurfaceIndex {
 public:
  explicit SurfaceIndex(TriMesh mesh);

  // Appends the triangles whose extents meet the box from lo to hi, each once, in an order that depends on the mesh and
  // the box alone. Cost: the triangles over the box's shadow.
  void AppendNear(const Point3& lo, const Point3& hi, std::vector<SpaceTriangle>& found) const;

 private:
  int64_t ColumnOf(double x) const;
  int64_t RowOf(double y) const;
  // Calls visit(bin) for every bin that the box meets.
  template <typename Visit>
  void ForBins(const Point3& lo, const Point3& hi, const Visit& visit) const;

  TriMesh mesh_;
  Point3 lo_{0, 0, 0};
  double step_ = 1;
  int64_t columns_ = 1, rows_ = 1;
  std::vector<int32_t> first_;      // of each bin into triangles_
  std::vector<int32_t> triangles_;  // bin by bin
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_SURFACE_INDEX_H_
