// A directed edge as one number.
#ifndef TILEMEND_COMMON_MESH_EDGE_KEY_H_
#define TILEMEND_COMMON_MESH_EDGE_KEY_H_

#include <cstdint>

namespace tilemend {

// For hash tables and sorting: edges with the same key are the same. The halves exchanged are the key of the way back.
inline uint64_t EdgeKey(int32_t from, int32_t to) {
  return static_cast<uint64_t>(static_cast<uint32_t>(from)) << 32 | static_cast<uint32_t>(to);
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_EDGE_KEY_H_
