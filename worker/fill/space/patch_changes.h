// Small changes of a patch: points move or merge, edges and triangles are divided or flipped, others are left out.
#ifndef TILEMEND_WORKER_FILL_SPACE_PATCH_CHANGES_H_
#define TILEMEND_WORKER_FILL_SPACE_PATCH_CHANGES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "worker/fill/space/free_outline.h"
#include "worker/fill/space/patch_edit.h"

namespace tilemend {

// Triangles that go and others that come.
struct PatchChange {
  std::vector<int32_t> out;
  std::vector<Triangle> in = {};
  std::optional<int32_t> gone = {};    // a vertex that no triangle has afterwards
  std::optional<Point3> point = {};    // of a new vertex, the next one of the patch
  std::optional<Point3> planned = {};  // where the plan has the new vertex, if it is on the free boundary
  std::optional<int32_t> freed = {};   // a vertex that comes to the free boundary
};

// A change whose new vertex may lie near a place, as far away as `size` metres and less; or one without a new vertex.
struct ChangeNear {
  PatchChange change;
  struct Place {
    Point3 place;
    double size;
  };
  std::vector<Place> places = {};
};

// The changes at triangle t: of its points that are not on the boundary, or on its free part, of its edges, and of
// itself. The boundary stays, but for what FreeOutline lets go.
//   middle  a place on the triangle at which it and its edges are divided
//   next    the number of the patch's next new vertex
// Cost: O(triangles) for each corner and edge.
std::vector<ChangeNear> ChangesAt(int32_t t, const Point3& middle, int32_t next, const LocalHole& hole,
                                  const PatchEdit& edit, const FreeOutline& outline);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_PATCH_CHANGES_H_
