// Ground that stays where it was while a part of a patch is made anew.
#ifndef TILEMEND_WORKER_FILL_SPACE_KEPT_GROUND_H_
#define TILEMEND_WORKER_FILL_SPACE_KEPT_GROUND_H_

#include <cstdint>
#include <functional>
#include <set>

#include "worker/fill/space/crossing_index.h"
#include "worker/fill/space/patch_edit.h"

namespace tilemend {

// The vertices inside a piece of a patch that only triangles have which face up. What comes instead of the piece is
// triangles between the vertices of its boundary: on ground that is not flat these pass above and below.
class KeptGround {
 public:
  //   piece     not empty
  //   boundary  vertices on the boundary of the piece
  KeptGround(const Piece& piece, const std::set<int32_t>& boundary, const PatchEdit& edit);

  // Whether triangles from number `first` on are near each of the vertices: above or below it, no further than a
  // quarter of the mean edge of the piece.
  bool IsKept(int32_t first, const PatchEdit& edit) const;

  // Puts vertices back that are not near, if the piece is gone: each divides a triangle from number `first` on that
  // faces up and is above or below it. One whose three triangles would cross something stays out.
  //   there  gives what is there
  void PutBack(int32_t first, const std::function<CrossingIndex()>& there, PatchEdit& edit) const;

 private:
  bool IsNear(int32_t v, int32_t first, const PatchEdit& edit) const;

  std::set<int32_t> vertices_;
  double most_ = 0;  // metres
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_KEPT_GROUND_H_
