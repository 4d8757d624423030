// Triangulation of a loop in space that crosses neither itself nor the surface around it.
#ifndef TILEMEND_WORKER_FILL_SPACE_SOUND_TRIANGULATION_H_
#define TILEMEND_WORKER_FILL_SPACE_SOUND_TRIANGULATION_H_

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "worker/fill/space/crossing_index.h"
#include "worker/fill/space/minimum_weight.h"

namespace tilemend {

// Longer loops are cut down first (clip_ears.h). What is clipped has a shape of its own. Over the edge of a thin body
// the triangles of a clipped loop cut it off, where the best of all triangulations goes around it.
inline constexpr int32_t kLongestSoundLoop = 400;

// As TriangulateLoop, without triangles that cross one of `surface`. Triangulations that cross themselves are avoided
// by search. Of two triangles that cross, the larger one is forbidden, and the loop is triangulated again. The same is
// done if a loop that passes a vertex twice gets an edge with more than two triangles. The result is empty if there is
// none without crossings of the surface, or none is found; with Misfits::kFew it then has few crossings. It may still
// cross itself if the search ends first. O(n log^2 n) for long loops; else O(n^3) triangles are looked at.
std::vector<Triangle> TriangulateSoundly(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                         const std::function<bool(int32_t, int32_t)>& allowed,
                                         const CrossingIndex& surface, Misfits misfits = Misfits::kNone);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_SOUND_TRIANGULATION_H_
