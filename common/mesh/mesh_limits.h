// How large the fill of one cell or mesh may be.
#ifndef TILEMEND_COMMON_MESH_MESH_LIMITS_H_
#define TILEMEND_COMMON_MESH_MESH_LIMITS_H_

#include <cstdint>

namespace tilemend {

// The fill of one cell, with the vertices of its rims, has fewer vertices than this. A worker leaves a hole open whose
// patch would bring it to as many or more. A tile whose band has more fails in its survey. The coordinator refuses a mesh
// in a result that has more.
inline constexpr int64_t kMaxResultPoints = 4'000'000;
inline constexpr int64_t kMaxResultTriangles = 2 * kMaxResultPoints;

// The same of all fills of a single mesh (`tilemend fill`), which are in no result. They take 0.5 to 7 kB a vertex
// (worker/fill/fill_memory.cc).
inline constexpr int64_t kMaxSingleMeshPoints = 20'000'000;

// Triangulations number the corners of triangles 4 t + k, in 32 bits.
static_assert(4 * 2 * kMaxSingleMeshPoints < INT32_MAX);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_MESH_LIMITS_H_
