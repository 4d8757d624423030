// The part of a hole's boundary that is the tile's own outline, or that of a piece of it.
#ifndef TILEMEND_WORKER_FILL_SPACE_FREE_OUTLINE_H_
#define TILEMEND_WORKER_FILL_SPACE_FREE_OUTLINE_H_

#include <cstdint>
#include <map>
#include <vector>

#include "worker/fill/hole/local_patch.h"

namespace tilemend {

// Where tiles or pieces of a tile overlap, the plan ends a hole at an outline beyond which other surface goes on. No
// other triangle has the edges there, so the patch may end a little beside them (kMaxOutlineAside, kMaxOutlineRise).
// Free are vertices that the plan made there, and points of the patch that come instead of them, or between them.
class FreeOutline {
 public:
  // `hole` must outlive it. O(n log n).
  explicit FreeOutline(const LocalHole& hole);

  // Whether a vertex of the patch is on the free boundary. O(log n).
  bool IsFree(int32_t v) const { return places_.contains(v); }
  // Whether the boundary may leave an edge. Precondition: one triangle of the patch has it. O(log n).
  bool IsFreeEdge(int32_t a, int32_t b) const;

  // Where the plan has a free vertex; `now` of another one.
  Point3 PlannedPlace(int32_t v, const Point3& now) const;
  // Whether the boundary may come to `p` where the plan has it at `planned`.
  //   faces_up  some of the surface there does. It stays nearer: its edge lies over or under surface beyond, and the
  //             fills of overlapping tiles lie near each other. Walls stand beside each other
  static bool MayLie(const Point3& planned, const Point3& p, bool faces_up);

  // Makes vertex v of the patch a free one.
  void Add(int32_t v, const Point3& planned) { places_[v] = planned; }

  // Tells LocalPatch::left_edges of a patch. Returns whether it ends near them (MayMoveOutline). O(n log n).
  bool TellLeft(LocalPatch& patch) const;

 private:
  const LocalHole& hole_;
  std::map<int32_t, Point3> places_;  // of the free vertices, in the plan
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_FREE_OUTLINE_H_
