// Closes a loop in space about one new point, where every triangulation of it crosses something.
#ifndef TILEMEND_WORKER_FILL_SPACE_CONE_FILL_H_
#define TILEMEND_WORKER_FILL_SPACE_CONE_FILL_H_

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/space/crossing_index.h"

namespace tilemend {

struct ConeFill {
  Point3 tip;
  std::vector<Triangle> triangles;  // over places of the loop; the tip is loop.size()
};

// Clips ears off the loop (clip_ears.h), none, some or as many as can be, and joins what is left to a tip. The tip is
// the middle of it or a place around that, off its plane too. Of the first clipping that leaves a sound cone takes the
// one of least area. So fins of the surface that stand in a small hole are passed by. None if all cross something.
//   loop, outside, allowed  as for ClipEars
//   place                   where a new point can be near another
// The tips tried turn with the loop. Cost: some 400 cones.
std::optional<ConeFill> CloseByCone(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                    const std::function<bool(int32_t, int32_t)>& allowed, const CrossingIndex& surface,
                                    const std::function<Point3(const Point3&)>& place);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_CONE_FILL_H_
