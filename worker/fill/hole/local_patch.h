// New geometry for a hole or a part of one.
#ifndef TILEMEND_WORKER_FILL_HOLE_LOCAL_PATCH_H_
#define TILEMEND_WORKER_FILL_HOLE_LOCAL_PATCH_H_

#include <optional>
#include <vector>

#include "common/records/cell_holes.h"
#include "worker/fill/hole/fill_failure.h"
#include "worker/fill/hole/local_hole.h"

namespace tilemend {

// Corners of triangles: a vertex of the LocalHole, or size() + k for new_points[k].
struct LocalPatch {
  FillFailure failure = FillFailure::kNone;  // another: no geometry
  std::vector<Point3> new_points = {};
  std::vector<Triangle> triangles = {};
  std::optional<HoldOut> hold_out = {};     // where the tension was chosen for this patch alone
  bool is_bare = false;                     // no new vertex could be laid where the way would have liked some
  int32_t loop_cuts = 0;                    // as HolePatch
  int32_t crossings = 0;                    // as HolePatch
  std::vector<int32_t> feet = {};           // of each vertex of the hole, as RaiseWalls returns them
  std::vector<VertexPair> left_edges = {};  // of LocalHole::free_edges: the patch ends beside them; sorted

  bool ok() const { return failure == FillFailure::kNone; }
};

inline SpaceTriangle InSpace(const LocalHole& hole, const LocalPatch& patch, const Triangle& t) {
  const auto at = [&](int32_t v) { return v < hole.size() ? hole.positions[v] : patch.new_points[v - hole.size()]; };
  return {at(t[0]), at(t[1]), at(t[2])};
}

// Adds the patch of a part to that of the hole.
void AddPart(const HolePart& part, const LocalPatch& of_part, const LocalHole& hole, LocalPatch& patch);

// Drops the new points that no triangle has. O(triangles).
void DropUnusedPoints(const LocalHole& hole, LocalPatch& patch);

// The patch as it leaves the filler: corners k >= 0 are rim vertices of the cell, -1 - k new points.
HolePatch ToHolePatch(const LocalHole& hole, LocalPatch patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_LOCAL_PATCH_H_
