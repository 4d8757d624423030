// How large the mesh of one result may be.
#ifndef TILEMEND_COMMON_MESH_MESH_LIMITS_H_
#define TILEMEND_COMMON_MESH_MESH_LIMITS_H_

#include <cstdint>

namespace tilemend {

// Of the fill of one cell, with the vertices of its rims, and of every other mesh between programs. A worker leaves a
// hole open whose patch would not fit. The coordinator refuses results that are larger.
inline constexpr int64_t kMaxResultPoints = 4'000'000;
inline constexpr int64_t kMaxResultTriangles = 2 * kMaxResultPoints;

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_MESH_LIMITS_H_
